// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/distance_colors.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace vcg_core {

Rgb distance_ramp(double fraction) {
  static constexpr std::array<std::array<double, 3>, 6> stops{
      {{214, 60, 50}, {250, 150, 90}, {254, 228, 140}, {222, 240, 246}, {140, 190, 220}, {65, 115, 185}}};
  const double position = std::clamp(fraction, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t lower = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const double t = position - static_cast<double>(lower);
  const auto mix = [&](std::size_t channel) {
    return static_cast<std::uint8_t>(std::lround((1 - t) * stops[lower][channel] + t * stops[lower + 1][channel]));
  };
  return {mix(0), mix(1), mix(2)};
}

std::vector<Rgb> distance_colors(const std::vector<double>& distance,
                                 const std::vector<std::array<std::size_t, 3>>& faces, int isolines) {
  if (isolines < 0) {
    throw InvalidParameter("isolines is " + std::to_string(isolines) + ", allowed is 0 or more");
  }
  double largest = 0;
  for (const double d : distance) {
    if (std::isfinite(d)) largest = std::max(largest, d);
  }

  std::vector<Rgb> colors(distance.size());
  std::transform(distance.begin(), distance.end(), colors.begin(), [largest](double d) {
    return std::isfinite(d) ? distance_ramp(largest > 0 ? d / largest : 0) : unreachable_color;
  });
  if (isolines == 0 || !(largest > 0)) return colors;

  // In steps, line k lies at k = 1 ... isolines.
  const double steps = isolines + 1.0;
  const auto in_steps = [&](std::size_t vertex) { return distance[vertex] / largest * steps; };
  const auto band = [isolines](double s) { return std::min(std::floor(s), static_cast<double>(isolines)); };

  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (!std::isfinite(distance[v])) continue;
    const double line = std::clamp(std::round(in_steps(v)), 1.0, static_cast<double>(isolines));
    if (std::abs(in_steps(v) - line) <= 0.04) colors[v] = isoline_color;
  }
  for (const auto& face : faces) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::size_t nearer = face[corner];
      std::size_t farther = face[(corner + 1) % 3];
      if (!std::isfinite(distance[nearer]) || !std::isfinite(distance[farther])) continue;
      if (distance[nearer] > distance[farther]) std::swap(nearer, farther);
      const double first_line =
          band(in_steps(nearer)) + 1;  // the first line beyond `nearer`, the last one before `farther`
      const double last_line = band(in_steps(farther));
      if (last_line < first_line) continue;
      const double before = first_line - in_steps(nearer);
      const double behind = in_steps(farther) - last_line;
      if (before <= behind || last_line > first_line) colors[nearer] = isoline_color;
      if (behind < before || last_line > first_line) colors[farther] = isoline_color;
    }
  }
  return colors;
}

}  // namespace vcg_core
