// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_text.h"

#include <json_figures/json_figures.h>
#include <cstdio>

namespace anisosmooth {
namespace {

using mesh_tools::Measurement;
using nlohmann::ordered_json;
using vcg_core::ParameterInfo;

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string header(const std::vector<std::string>& cells) {
  std::string line = row(cells) + "|---|";
  for (std::size_t i = 1; i < cells.size(); ++i) line += "--:|";
  return line + "\n";
}

std::string volume(const std::optional<double>& percent) { return percent ? number(*percent, 2) : "-"; }

std::vector<std::string> figure_cells(const std::string& name, const Measurement& m) {
  return {name,
          number(m.normal_error.mean, 2),
          number(m.normal_error.median, 2),
          number(m.normal_error.percentile_95, 2),
          m.sharp_normal_error.faces > 0 ? number(m.sharp_normal_error.mean, 2) : "-",
          number(m.distance_rms, 3),
          number(m.distance_max, 3),
          volume(m.volume_change_percent),
          std::to_string(m.flipped_faces),
          number(m.true_tangential_drift, 3),
          m.tangential_drift ? number(*m.tangential_drift, 3) : "-"};
}

std::string figure_table(const Comparison& comparison) {
  std::string text = header({"method", "normal error, mean", "median", "95 %", "at sharp edges, mean", "distance, RMS",
                             "max", "volume, %", "flipped faces", "drift from truth", "drift from noisy"});
  text += row(figure_cells("noisy", *comparison.noisy_figures));
  for (const MethodRun& run : comparison.runs) text += row(figure_cells(run.method.title, *run.figures));
  return text +
         "\nNormal errors in degrees, over faces; sharp edges are those of the reference with more than 30 degrees."
         " Distances (to the surface of the reference) and drift (sideways, RMS) in average edge lengths of the"
         " reference.\n";
}

std::string parameter_text(const MethodRun& run) {
  std::string text;
  for (const ParameterInfo& row : run.method.parameters) {
    if (row.kind() != ParameterInfo::Kind::real && row.kind() != ParameterInfo::Kind::integer) continue;
    text += (text.empty() ? "" : ", ") + row.name + " " + to_json(row, run.parameters).dump();
  }
  return text;
}

std::string run_table(const Comparison& comparison) {
  std::string text = header({"method", "parameters", "seconds", "moved", "displacement, RMS", "max", "volume, %"});
  for (const MethodRun& run : comparison.runs) {
    const vcg_core::SmoothingReport& report = run.report;
    const double e = report.average_edge_length;
    std::optional<double> change;
    if (report.volume_before != 0)
      change = 100 * (report.volume_after - report.volume_before) / std::abs(report.volume_before);
    text += row({run.method.title, parameter_text(run), number(run.seconds, 3), std::to_string(report.moved_vertices),
                 number(report.rms_displacement / e, 3), number(report.max_displacement / e, 3), volume(change)});
  }
  return text +
         "\nDisplacement in average edge lengths of the noisy mesh, over the moved vertices; volume against the noisy"
         " mesh.\n";
}

}  // namespace

ordered_json to_json(const Comparison& comparison) {
  ordered_json json = {{"vertices", comparison.noisy.mesh.vn}, {"faces", comparison.noisy.mesh.fn}};
  if (comparison.noisy_figures) json["noisy_figures"] = to_json(*comparison.noisy_figures);
  json["methods"] = ordered_json::array();
  for (const MethodRun& run : comparison.runs) {
    ordered_json entry = {{"method", run.method.name},        {"title", run.method.title},
                          {"file", run.method.name + ".ply"}, {"parameters", to_json(run.method, run.parameters)},
                          {"seconds", run.seconds},           {"report", to_json(run.report)}};
    if (run.figures) entry["figures"] = to_json(*run.figures);
    json["methods"].push_back(entry);
  }
  return json;
}

std::string to_markdown(const Comparison& comparison, const std::string& noisy_name, const std::string& reference_name,
                        const std::vector<std::string>& pictures) {
  std::string text = "# Six smoothing methods on " + noisy_name + "\n\n" + std::to_string(comparison.noisy.mesh.vn) +
                     " vertices, " + std::to_string(comparison.noisy.mesh.fn) +
                     " faces; the parameters are the paper's"
                     " Table 1.\n\n";
  if (comparison.reference) text += "Against " + reference_name + ":\n\n" + figure_table(comparison) + "\n";
  text += run_table(comparison);
  for (const std::string& picture : pictures)
    text.append("\n![").append(picture).append("](").append(picture).append(")\n");
  return text;
}

}  // namespace anisosmooth
