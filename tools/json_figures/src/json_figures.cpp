// SPDX-License-Identifier: GPL-3.0-or-later
#include <json_figures/json_figures.h>

namespace anisosmooth {

using nlohmann::ordered_json;

ordered_json to_json(const vcg_core::SmoothingReport& report) {
  ordered_json json = {{"average_edge_length", report.average_edge_length},
                       {"sigma_c_length", report.sigma_c_length},
                       {"sigma_s_length", report.sigma_s_length},
                       {"rho_length", report.rho_length},
                       {"vertices", report.vertices},
                       {"moved_vertices", report.moved_vertices},
                       {"fixed_vertices", report.fixed_vertices},
                       {"skipped_vertices",
                        {{"isolated", report.skipped_vertices.isolated},
                         {"undefined_normal", report.skipped_vertices.undefined_normal},
                         {"empty_neighbourhood", report.skipped_vertices.empty_neighbourhood}}},
                       {"max_displacement", report.max_displacement},
                       {"rms_displacement", report.rms_displacement},
                       {"volume_before", report.volume_before},
                       {"volume_after", report.volume_after},
                       {"border_vertices", report.border_vertices},
                       {"non_manifold_vertices", report.non_manifold_vertices},
                       {"coincident_vertices", report.coincident_vertices},
                       {"nearly_coincident_vertices", report.nearly_coincident_vertices},
                       {"degenerate_faces", report.degenerate_faces},
                       {"faces", report.faces},
                       {"flipped_faces", report.flipped_faces},
                       {"far_moved_vertices", report.far_moved_vertices},
                       {"beyond_ring_vertices", report.beyond_ring_vertices},
                       {"bounded_vertices", report.bounded_vertices},
                       {"approximate_neighbourhoods", report.approximate_neighbourhoods},
                       {"closed", report.closed},
                       {"coordinate_spacing", report.coordinate_spacing}};
  if (report.estimated_noise) json["estimated_noise"] = *report.estimated_noise;
  if (report.crease_edges > 0) json["crease_edges"] = report.crease_edges;
  if (report.self_intersections) json["self_intersections"] = *report.self_intersections;
  json["warnings"] = report.warnings();
  return json;
}

ordered_json to_json(const vcg_core::ParameterInfo& row, const vcg_core::SmoothingParameters& parameters) {
  const double value = row.value(parameters);
  switch (row.kind()) {
    case vcg_core::ParameterInfo::Kind::integer:
      return static_cast<int>(value);
    case vcg_core::ParameterInfo::Kind::flag:
      return value != 0;
    case vcg_core::ParameterInfo::Kind::choice:
      return row.text(parameters);
    default:
      return value;
  }
}

ordered_json to_json(const vcg_core::MethodInfo& method, const vcg_core::SmoothingParameters& parameters) {
  ordered_json json = ordered_json::object();
  for (const vcg_core::ParameterInfo& row : method.parameters) json[row.name] = to_json(row, parameters);
  return json;
}

ordered_json to_json(const mesh_tools::Measurement& figures) {
  ordered_json json = {{"vertices", figures.vertices},
                       {"faces", figures.faces},
                       {"average_edge_length", figures.average_edge_length},
                       {"normal_error_mean", figures.normal_error.mean},
                       {"normal_error_median", figures.normal_error.median},
                       {"normal_error_percentile_95", figures.normal_error.percentile_95},
                       {"sharp_faces", figures.sharp_normal_error.faces},
                       {"sharp_normal_error_mean", figures.sharp_normal_error.mean},
                       {"sharp_normal_error_median", figures.sharp_normal_error.median},
                       {"sharp_normal_error_percentile_95", figures.sharp_normal_error.percentile_95},
                       {"distance_rms", figures.distance_rms},
                       {"distance_max", figures.distance_max},
                       {"reverse_distance_rms", figures.reverse_distance_rms},
                       {"reverse_distance_max", figures.reverse_distance_max},
                       {"volume_change_percent", nullptr},
                       {"flipped_faces", figures.flipped_faces},
                       {"degenerate_faces", figures.degenerate_faces},
                       {"true_tangential_drift", figures.true_tangential_drift}};
  if (figures.volume_change_percent) json["volume_change_percent"] = *figures.volume_change_percent;
  if (figures.tangential_drift) json["tangential_drift"] = *figures.tangential_drift;
  return json;
}

std::string json_text(const ordered_json& json) {
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace anisosmooth
