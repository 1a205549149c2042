// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <support/flat_mesh.h>
#include <vcg_core/mesh/mesh_view.h>

namespace test_support {

/// A mesh as an array of numbers and an array of indices.
template <class Real = double, class Integer = std::uint32_t>
struct Packed {
  std::vector<Real> positions;
  std::vector<Integer> triangles;

  explicit Packed(const FlatMesh& mesh) {
    for (const Point& p : mesh.points)
      for (int k = 0; k < 3; ++k) positions.push_back(static_cast<Real>(p[k]));
    for (const Triangle& f : mesh.faces)
      for (const std::size_t v : f) triangles.push_back(static_cast<Integer>(v));
  }

  std::size_t vertices() const { return positions.size() / 3; }
  Point point(std::size_t v) const { return {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]}; }

  vcg_core::MeshView view() {
    return vcg_core::packed_mesh(positions.data(), vertices(), triangles.data(), triangles.size() / 3);
  }
};

}  // namespace test_support
