// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/smoothing_report.h>

#include <cmath>
#include <cstdio>

namespace vcg_core {

namespace {

using Sentences = std::vector<std::string>;

/// With three significant digits, which is what a sentence can use.
std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string percent(double part, double whole) { return digits(100 * part / whole) + " %"; }

/// "1 vertex" or "2 vertices".
std::string vertices_text(std::size_t n) { return std::to_string(n) + (n == 1 ? " vertex" : " vertices"); }

/// Two digits that are no less than the length.
std::string digits_above(double length) {
  const double unit = std::pow(10, std::floor(std::log10(length)) - 1);
  return digits(std::ceil(length / unit) * unit);
}

void describe_mesh(const SmoothingReport& report, Sentences& sentences) {
  if (report.nearly_coincident_vertices > 0 && 10 * report.nearly_coincident_vertices >= report.border_vertices) {
    const std::string distance = digits_above(report.nearly_coincident_distance);
    sentences.push_back(std::to_string(report.nearly_coincident_vertices) + " of " +
                        vertices_text(report.border_vertices) + " on borders lie within " + distance +
                        " of another one that they are not connected with, so the surface is torn there; join them by"
                        " the command line's --weld-distance " +
                        distance + ", or run MeshLab's \"Merge Close Vertices\" first");
  }
  const SkippedVertices& skipped = report.skipped_vertices;
  if (skipped.isolated > 0)
    sentences.push_back(std::to_string(skipped.isolated) + " vertices belong to no face and stay in place");
  if (skipped.undefined_normal > 0)
    sentences.push_back(std::to_string(skipped.undefined_normal) +
                        " vertices have no defined normal (faces without area, or facing opposite ways) and stay in"
                        " place");
  if (skipped.empty_neighbourhood > 0)
    sentences.push_back(std::to_string(skipped.empty_neighbourhood) +
                        " vertices have nothing within the cut-off distance to be smoothed by and stay in place; a"
                        " larger sigma_c reaches farther");
  if (report.coordinate_spacing > 0.01 * report.average_edge_length)
    sentences.push_back("the mesh lies so far from the origin that its coordinates are stored in steps of " +
                        digits(report.coordinate_spacing) + ", " +
                        percent(report.coordinate_spacing, report.average_edge_length) +
                        " of the average edge length; move it to the origin before it is saved, or use double"
                        " precision");
}

bool volume_changed(const SmoothingReport& report) {
  const double change = std::abs(report.volume_after - report.volume_before);
  // The second: rounding may leave something of the volume of a flat shape.
  return report.closed && change > 0.05 * std::abs(report.volume_before) &&
         change > 1e-6 * std::pow(report.average_edge_length, 3);
}

void describe_result(const SmoothingReport& report, Sentences& sentences) {
  const auto add = [&](const std::string& what) {
    sentences.push_back(report.advice.empty() ? what : what + "; " + report.advice);
  };
  if (static_cast<double>(report.flipped_faces) > 0.01 * static_cast<double>(report.faces))
    add(std::to_string(report.flipped_faces) + " of " + std::to_string(report.faces) + " faces (" +
        percent(static_cast<double>(report.flipped_faces), static_cast<double>(report.faces)) +
        ") face the opposite way from before: the surface folds there, unless strong noise had turned them");
  if (volume_changed(report))
    add("the enclosed volume changed from " + digits(report.volume_before) + " to " + digits(report.volume_after) +
        (report.volume_before == 0
             ? ""
             : ", by " + percent(report.volume_after - report.volume_before, std::abs(report.volume_before))));
  if (report.far_moved_vertices > 0)
    add(vertices_text(report.far_moved_vertices) +
        " moved by more than twice the average edge length, the farthest by " +
        digits(report.max_displacement / report.average_edge_length) + " times that length");
  if (report.beyond_ring_vertices > 0)
    add(vertices_text(report.beyond_ring_vertices) + " moved farther than the longest edge there");
  if (report.approximate_neighbourhoods > 0)
    sentences.push_back("around " + vertices_text(report.approximate_neighbourhoods) +
                        " distances along the surface are approximate, as exact ones would take very long there");
  if (report.self_intersections.value_or(0) > 0)
    add(std::to_string(*report.self_intersections) + " faces of the result cut through other faces");
}

}  // namespace

std::vector<std::string> SmoothingReport::warnings() const {
  Sentences sentences;
  describe_mesh(*this, sentences);
  describe_result(*this, sentences);
  sentences.insert(sentences.end(), notes.begin(), notes.end());
  return sentences;
}

}  // namespace vcg_core
