// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <mesh_tools/mesh.h>

namespace mesh_tools {
class SurfaceDistance;
}

namespace mesh_tools::shapes {

/// A closed shape as a set of points, turned about a fixed axis that is parallel to nothing of it.
class Solid {
 public:
  /// @param shape     name of a closed shape of all_shapes()
  /// @param vertices  of the surface that will be made of it: its own is finer, so that curves stay curves
  /// @param tilt      angle in degrees
  Solid(const std::string& shape, std::size_t vertices, double tilt);
  ~Solid();
  Solid(Solid&&) noexcept;

  const vcg::Box3d& box() const { return mesh_.bbox; }
  /// For each axis: the area of the surface as seen along it, from both sides and whether hidden or not.
  vcg::Point3d shadows() const;

  /// For columns of points in direction z over a grid: inside[(j * columns + i) * heights.size() + k] tells whether
  /// (x[i], y[j], heights[k]) is in the solid.
  std::vector<bool> contains(const std::vector<double>& x, const std::vector<double>& y,
                             const std::vector<double>& heights) const;
  /// The point of the surface nearest to p: exact for sphere and torus, on a fine mesh for the others.
  vcg::Point3d nearest(const vcg::Point3d& p) const;

 private:
  /// Signed distance and nearest point of a shape that has a formula, before the turn.
  struct Formula {
    std::function<bool(const vcg::Point3d&)> contains;
    std::function<vcg::Point3d(const vcg::Point3d&)> nearest;
  };

  vcg::Point3d turned(const vcg::Point3d& p, double direction) const;
  std::vector<std::vector<double>> crossings(const std::vector<double>& x, const std::vector<double>& y) const;

  double tilt_;  // radians
  Mesh mesh_;    // turned
  Formula formula_;
  std::unique_ptr<SurfaceDistance> surface_;
};

}  // namespace mesh_tools::shapes
