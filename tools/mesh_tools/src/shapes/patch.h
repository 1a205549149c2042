// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <mesh_tools/mesh.h>
#include <mesh_tools/random.h>

#include "delaunay.h"

namespace mesh_tools::shapes {

/// Wanted edge length at a place.
using Spacing = std::function<double(const vcg::Point3d&)>;

/// A vertex of the surface under construction, with its place in the plane of the patch that uses it.
struct Corner {
  int vertex;
  Point2 place;
};

/// A piece of surface that unrolls to the plane without stretch: plane, cylinder.
struct Patch {
  std::vector<std::vector<Corner>> loops;              ///< closed; the patch is what they enclose (even-odd rule)
  std::function<vcg::Point3d(const Point2&)> surface;  ///< u x v points outwards
  double smallest_spacing;                             ///< a lower bound of the wanted edge length on it
};

/// Builds triangle meshes from patches that share the vertices of their common boundaries, so that the whole is
/// watertight. Boundary edges are kept; inside, points lie about one edge length apart and are connected by Delaunay.
class SurfaceBuilder {
 public:
  /// @param spacing      wanted edge length
  /// @param uniform      true if it is the same everywhere
  /// @param triangulate  false: only vertices are made, which is quick and enough to count them
  SurfaceBuilder(Spacing spacing, bool uniform, bool triangulate);

  int add_vertex(const vcg::Point3d& position);
  const vcg::Point3d& position(int vertex) const { return vertices_[vertex]; }
  std::size_t vertex_count() const { return vertices_.size(); }
  double spacing(const vcg::Point3d& position) const { return spacing_(position); }

  void add_patch(const Patch& patch);
  void add_triangle(int a, int b, int c) { triangles_.push_back({a, b, c}); }

  std::vector<vcg::Point3d>& vertices() { return vertices_; }
  void write_to(Mesh& mesh) const;

 private:
  Spacing spacing_;
  bool uniform_;
  bool triangulate_;
  Random random_{20260101};
  std::vector<vcg::Point3d> vertices_;
  std::vector<std::array<int, 3>> triangles_;
};

/// Normals and bounding box.
void finish_mesh(Mesh& mesh);

/// Replaces `mesh` by the given vertices and triangles, with normals and bounding box.
void fill_mesh(const std::vector<vcg::Point3d>& vertices, const std::vector<std::array<int, 3>>& triangles, Mesh& mesh);

}  // namespace mesh_tools::shapes
