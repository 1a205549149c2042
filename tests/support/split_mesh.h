// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// A mesh cut apart: where faces of different charts meet, each chart has a vertex of its own.
struct SplitMesh {
  FlatMesh mesh;
  std::vector<std::size_t> original;  ///< of each vertex the one that it is a copy of
};

/// Cuts along the borders of the charts; the vertices come in a random order. Vertices without faces stay one.
/// @param chart  of each face
SplitMesh split(const FlatMesh& mesh, const std::vector<std::size_t>& chart, unsigned seed);

/// Charts of random shape and size, grown from random faces over common edges.
std::vector<std::size_t> random_charts(const FlatMesh& mesh, std::size_t count, unsigned seed);

/// Each face a chart: a soup of triangles, as in an STL file.
std::vector<std::size_t> single_faces(const FlatMesh& mesh);

}  // namespace test_support
