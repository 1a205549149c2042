// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
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
  return distance <= (std::numeric_limits<Quality>::max)() ? static_cast<Quality>(distance) : Quality(-1);
}

/// The colour at `fraction` in [0, 1] of the largest distance: from red at the source through yellow to blue. All of
/// the ramp is bright enough for the dark iso-lines to stand out.
Rgb distance_ramp(double fraction);

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
std::vector<Rgb> distance_colors(const std::vector<double>& distance,
                                 const std::vector<std::array<std::size_t, 3>>& faces, int isolines);

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
