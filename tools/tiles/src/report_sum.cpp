// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_sum.h"

#include <algorithm>
#include <cmath>

namespace tiles {
namespace {

using vcg_core::SmoothingReport;

/// Calls visit(name, member) for figures that add up over the pieces.
template <class Report, class Visit>
void for_each_count(Report& r, const Visit& visit) {
  visit("vertices", r.vertices);
  visit("moved_vertices", r.moved_vertices);
  visit("fixed_vertices", r.fixed_vertices);
  visit("isolated", r.skipped_vertices.isolated);
  visit("undefined_normal", r.skipped_vertices.undefined_normal);
  visit("empty_neighbourhood", r.skipped_vertices.empty_neighbourhood);
  visit("volume_before", r.volume_before);
  visit("volume_after", r.volume_after);
  visit("border_vertices", r.border_vertices);
  visit("non_manifold_vertices", r.non_manifold_vertices);
  visit("coincident_vertices", r.coincident_vertices);
  visit("nearly_coincident_vertices", r.nearly_coincident_vertices);
  visit("degenerate_faces", r.degenerate_faces);
  visit("faces", r.faces);
  visit("flipped_faces", r.flipped_faces);
  visit("far_moved_vertices", r.far_moved_vertices);
  visit("beyond_ring_vertices", r.beyond_ring_vertices);
  visit("bounded_vertices", r.bounded_vertices);
  visit("approximate_neighbourhoods", r.approximate_neighbourhoods);
}

/// Those of which the largest is the whole's; some are the same in all pieces.
template <class Report, class Visit>
void for_each_largest(Report& r, const Visit& visit) {
  visit("average_edge_length", r.average_edge_length);
  visit("sigma_c_length", r.sigma_c_length);
  visit("sigma_s_length", r.sigma_s_length);
  visit("rho_length", r.rho_length);
  visit("max_displacement", r.max_displacement);
  visit("nearly_coincident_distance", r.nearly_coincident_distance);
  visit("coordinate_spacing", r.coordinate_spacing);
}

double sum_of_squares(const SmoothingReport& r) {
  return r.rms_displacement * r.rms_displacement * static_cast<double>(r.moved_vertices);
}

}  // namespace

nlohmann::ordered_json report_to_json(const SmoothingReport& report) {
  nlohmann::ordered_json json = {{"closed", report.closed},
                                 {"rms_displacement", report.rms_displacement},
                                 {"notes", report.notes},
                                 {"advice", report.advice}};
  const auto put = [&](const char* name, const auto& value) { json[name] = value; };
  for_each_count(report, put);
  for_each_largest(report, put);
  if (report.estimated_noise) json["estimated_noise"] = *report.estimated_noise;
  return json;
}

SmoothingReport report_from_json(const nlohmann::ordered_json& json) {
  SmoothingReport report;
  report.closed = json.at("closed");
  report.rms_displacement = json.at("rms_displacement");
  report.notes = json.at("notes").get<std::vector<std::string>>();
  report.advice = json.at("advice").get<std::string>();
  const auto take = [&](const char* name, auto& value) { json.at(name).get_to(value); };
  for_each_count(report, take);
  for_each_largest(report, take);
  if (json.contains("estimated_noise")) report.estimated_noise = json.at("estimated_noise").get<double>();
  return report;
}

void add_report(const SmoothingReport& piece, SmoothingReport& sum) {
  if (sum.vertices == 0) {
    sum = piece;
    return;
  }
  sum.closed = sum.closed && piece.closed;
  const double squares = sum_of_squares(sum) + sum_of_squares(piece);

  const nlohmann::ordered_json added = report_to_json(piece);
  for_each_count(sum,
                 [&](const char* name, auto& value) { value += added.at(name).get<std::decay_t<decltype(value)>>(); });
  for_each_largest(sum,
                   [&](const char* name, double& value) { value = std::max(value, added.at(name).get<double>()); });
  if (sum.moved_vertices > 0) sum.rms_displacement = std::sqrt(squares / static_cast<double>(sum.moved_vertices));
  for (const std::string& note : piece.notes)
    if (std::find(sum.notes.begin(), sum.notes.end(), note) == sum.notes.end()) sum.notes.push_back(note);
  if (sum.advice.empty()) sum.advice = piece.advice;
}

}  // namespace tiles
