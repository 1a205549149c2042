#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <vcg_core/errors.h>

namespace vcg_core {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Rgb& other) const { return red == other.red && green == other.green && blue == other.blue; }
  bool operator!=(const Rgb& other) const { return !(*this == other); }
};

/// The colour of the iso-lines, and of vertices that no path of faces reaches.
inline constexpr Rgb isoline_color{25, 25, 25};
inline constexpr Rgb unreachable_color{128, 128, 128};

/// The vertex quality that stands for a geodesic distance: the distance itself, and -1 where it is infinite, or more
/// than a mesh in single precision can store: files and programs take no infinity well, and no distance is negative.
template <class Quality = double>
Quality distance_quality(double distance) {
  return distance <= std::numeric_limits<Quality>::max() ? static_cast<Quality>(distance) : Quality(-1);
}

/// The colour at `fraction` in [0, 1] of the largest distance: from red at the source through yellow to blue. All of
/// the ramp is bright enough for the dark iso-lines to stand out.
inline Rgb distance_ramp(double fraction) {
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

/// Colours for a map of geodesic distances, as in the paper's figures 5b and 6b: the ramp, with `isolines` dark lines
/// at equal steps between 0 and the largest finite distance.
///
/// A vertex is on a line when it is the nearer end of an edge that the line crosses, which makes every line an unbroken
/// chain of vertices whatever the size of the triangles, or when it lies within 4 % of a step of it, which keeps lines
/// visible on very fine meshes.
///
/// @param distance  one per vertex, >= 0; infinity where no path leads: these become `unreachable_color`
/// @param faces     vertex indices of the triangles, below distance.size()
/// @param isolines  number of lines; >= 0
/// @throws InvalidParameter if isolines is negative
inline std::vector<Rgb> distance_colors(const std::vector<double>& distance,
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

/// The same for a vcglib mesh; `distance` holds one value per element of mesh.vert, as `geodesic_distances` returns it.
template <class Mesh>
std::vector<Rgb> distance_colors(const Mesh& mesh, const std::vector<double>& distance, int isolines) {
  std::vector<std::array<std::size_t, 3>> faces;
  faces.reserve(mesh.face.size());
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    const auto index = [&](int corner) { return static_cast<std::size_t>(face.cV(corner) - mesh.vert.data()); };
    faces.push_back({index(0), index(1), index(2)});
  }
  return distance_colors(distance, faces, isolines);
}

}  // namespace vcg_core
