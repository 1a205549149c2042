// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_summary.h"

#include <iostream>

namespace anisosmooth {

using nlohmann::ordered_json;
using vcg_core::MethodInfo;
using vcg_core::SmoothingReport;

void print_summary(const std::string& output, const MethodInfo& method, const SmoothingReport& report) {
  std::cout << method.title << "\n";
  std::cout << "average edge length " << report.average_edge_length;
  if (report.sigma_c_length > 0) std::cout << ", sigma_c " << report.sigma_c_length;
  if (report.sigma_s_length > 0) std::cout << ", sigma_s " << report.sigma_s_length;
  if (report.rho_length > 0) std::cout << ", rho " << report.rho_length;
  if (report.estimated_noise) std::cout << ", estimated noise " << *report.estimated_noise;
  std::cout << "\nmoved " << report.moved_vertices << " of " << report.vertices << " vertices";
  if (report.fixed_vertices > 0) std::cout << ", " << report.fixed_vertices << " held";
  if (report.skipped_vertices.total() > 0) std::cout << ", " << report.skipped_vertices.total() << " skipped";
  std::cout << "; displacement rms " << report.rms_displacement << ", max " << report.max_displacement
            << "\nvolume before " << report.volume_before << ", after " << report.volume_after;
  if (report.flipped_faces > 0) std::cout << "; faces turned over " << report.flipped_faces;
  if (report.crease_edges > 0) std::cout << "; edges kept as creases " << report.crease_edges;
  if (report.bounded_vertices > 0) std::cout << "; vertices held back " << report.bounded_vertices;
  if (report.self_intersections) std::cout << "; faces that cut through others " << *report.self_intersections;
  std::cout << "\nwritten to " << output << "\n";
}

ordered_json smoothing_json(const MethodInfo& method, const vcg_core::SmoothingParameters& parameters,
                            const LimitOptions& limits, const SmoothingReport& report) {
  ordered_json json = {{"method", method.name}, {"parameters", to_json(method, parameters)}};
  add_limits(limits, json["parameters"]);
  json.update(to_json(report));
  return json;
}

tiles::ReportFile report_file(const std::string& path) {
  if (path.empty()) return {};
  return [path](const tiles::Finished& finished) {
    const MethodInfo& method = vcg_core::method_info(finished.job.method);
    const LimitOptions limits{finished.job.limits, {}};
    return tiles::ReportText{path, json_text(smoothing_json(method, finished.job.parameters, limits, finished.report))};
  };
}

}  // namespace anisosmooth
