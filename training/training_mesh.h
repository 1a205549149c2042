// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

namespace training {

/// A noisy mesh and what its faces' normals should be.
struct TrainingMesh {
  mesh_tools::Mesh noisy;
  std::vector<vcg::Point3d> normal;  ///< by face, unit; zero where it is not known
  const char* family;
};

/// The mesh of this number among those of a seed: a generated shape, a triangulation of it, and noise of some kind.
TrainingMesh make_training_mesh(std::uint64_t seed, std::size_t number);

/// A choice with the given chances, which need not add up to 1.
std::size_t choose(mesh_tools::Random& random, const std::vector<double>& chances);

/// Uniform between the two.
double between(mesh_tools::Random& random, double least, double most);

/// Normals of the faces as they lie.
std::vector<vcg::Point3d> face_normals(const mesh_tools::Mesh& mesh);

/// Replaces the mesh. Vertices without faces are left out.
void build(mesh_tools::Mesh& mesh, const std::vector<vcg::Point3d>& vertices,
           const std::vector<std::array<std::size_t, 3>>& faces);

}  // namespace training
