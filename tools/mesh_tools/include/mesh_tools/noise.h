// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

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

/// Angle-weighted vertex normals of unit length; zero where there is none. Vertices at exactly the same place have the
/// same, of the faces of all.
std::vector<vcg::Point3d> vertex_normals(const Mesh& mesh);

}  // namespace mesh_tools
