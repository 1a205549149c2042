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
  /// The point of the surface that is nearest to `point`.
  vcg::Point3d nearest(const vcg::Point3d& point) const;

 private:
  struct Node {
    vcg::Point3d low, high;
    int first, count;  // leaf: triangles first..first+count; else count = 0, children at first and first + 1
  };
  using Triangle = std::array<vcg::Point3d, 3>;
  struct Nearest {
    double squared_distance;
    int triangle;  // -1: none is nearer than the bound
  };

  Nearest search(const vcg::Point3d& point, double squared_bound) const;
  void build(int node, int first, int last, std::vector<vcg::Point3d>& centres, std::vector<int>& order);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

/// Squared distance from a point to a triangle; a triangle without area counts as its edges.
double squared_distance_to_triangle(const vcg::Point3d& point, const std::array<vcg::Point3d, 3>& triangle);
vcg::Point3d nearest_of_triangle(const vcg::Point3d& point, const std::array<vcg::Point3d, 3>& triangle);

}  // namespace mesh_tools
