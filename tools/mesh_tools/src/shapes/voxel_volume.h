// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <vcg/space/point3.h>

#include "solid.h"

namespace mesh_tools::shapes {

/// A binary volume: which voxels have their centre inside a solid. There is an empty voxel around all.
class VoxelVolume {
 public:
  VoxelVolume(const Solid& solid, double pixel, double slice_distance);

  const std::array<int, 3>& size() const { return size_; }
  bool at(int i, int j, int k) const {
    return inside_[(static_cast<std::size_t>(j) * size_[0] + i) * size_[2] + static_cast<std::size_t>(k)];
  }
  vcg::Point3d centre(int i, int j, int k) const { return {centres_[0][i], centres_[1][j], centres_[2][k]}; }
  /// Pairs of neighbouring voxels of which one is inside: the vertices of the volume's surface.
  std::size_t boundary_pairs() const;

 private:
  std::array<int, 3> size_;
  std::array<std::vector<double>, 3> centres_;
  std::vector<bool> inside_;
};

/// The boundary of the voxels inside, by marching cubes.
void extract_surface(const VoxelVolume& volume, Mesh& mesh);

}  // namespace mesh_tools::shapes
