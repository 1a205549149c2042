// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <mesh_tools/mesh.h>

namespace mesh_tools {

/// Distance from any point to the surface of a mesh, exact up to rounding, by a tree of boxes over its triangles.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const Mesh& mesh);

  /// @param bound  a distance that is known to suffice; the result is at most this
  double operator()(const vcg::Point3d& point, double bound) const;

 private:
  struct Node {
    vcg::Point3d low, high;
    int first, count;  // leaf: triangles first..first+count; else count = 0, children at first and first + 1
  };
  using Triangle = std::array<vcg::Point3d, 3>;

  void build(int node, int first, int last, std::vector<vcg::Point3d>& centres, std::vector<int>& order);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

/// Squared distance from a point to a triangle; a triangle without area counts as its edges.
double squared_distance_to_triangle(const vcg::Point3d& point, const std::array<vcg::Point3d, 3>& triangle);

}  // namespace mesh_tools
