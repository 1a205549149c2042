// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <mesh_tools/mesh.h>

namespace mesh_tools {

enum class NoiseDirection {
  normal,  ///< along the angle-weighted vertex normal of the mesh as given
  any      ///< along a unit vector that is uniform on the sphere
};

/// Moves every vertex along `direction` by a distance that is normal with mean 0 and standard deviation `level` |e|, as
/// benchmarks of denoising do; so the standard deviation of the length of the move is the same for both directions.
/// The same seed gives the same noise on every platform, up to the rounding of log, sin and cos.
/// Vertices at exactly the same place move as one, so that seams stay closed.
/// Vertices without a normal (isolated, or with degenerate faces only) do not move in direction `normal`.
/// @param level  in average edge lengths; >= 0 and finite
/// @throws std::invalid_argument
void add_noise(Mesh& mesh, double level, std::uint64_t seed, NoiseDirection direction);

/// What noise of scanners differs in from that of benchmarks. Lengths are in average edge lengths |e| unless it is said
/// otherwise. All of it can be combined.
struct NoiseModel {
  /// Standard deviation of the distance by which a vertex moves, where nothing below says otherwise.
  double level = 0;
  std::uint64_t seed = 1;
  NoiseDirection direction = NoiseDirection::normal;

  /// Moves of vertices at distance d have the correlation exp(-d^2 / correlation^2); 0: none. Only along the surface:
  /// vertices that no path of edges within 2 correlations joins are independent.
  double correlation = 0;
  /// Probability with which a vertex moves at all; above 0, at most 1. Below 1 the noise is impulsive.
  double share = 1;
  /// The level at the end of the mesh in direction `axis`; from the other end, where it is `level`, it changes
  /// linearly.
  std::optional<double> level_far;
  /// Place of a depth camera, in the mesh's unit, finite and not at a vertex. Vertices move along the ray from there,
  /// in the place of `direction`, by level (d / d0)^2 / max(cos a, 0.2): d is the distance, d0 its mean over the
  /// vertices, a the angle between ray and vertex normal (0 where there is none). So is the noise of triangulation:
  /// that of the disparity is the same everywhere, that of the depth grows with the square of the distance (Khoshelham
  /// and Elberink 2012), and on slanted surfaces a pixel's width counts as depth.
  std::optional<vcg::Point3d> camera;
  /// Afterwards all positions are rounded, in direction `axis`, to multiples of this, counted from the origin; 0: not.
  double step = 0;
  /// A direction of any length but 0.
  vcg::Point3d axis{0, 0, 1};
};

/// The same with noise of any kind. Without any of the additions the moves are those of the simpler function, bit for
/// bit.
/// @throws std::invalid_argument for a value that is not allowed
void add_noise(Mesh& mesh, const NoiseModel& model);

/// Angle-weighted vertex normals of unit length; zero where there is none. Vertices at exactly the same place have the
/// same, of the faces of all.
std::vector<vcg::Point3d> vertex_normals(const Mesh& mesh);

}  // namespace mesh_tools
