// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/mesh/mesh_view.h>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Colours and scalars, one number after the other for each copy of each vertex, as RawMesh::host_vertex has them.
/// Colours in [0, 255].
struct VertexAttributes {
  bool has_color = false;
  bool has_scalar = false;
  Array<double> value;

  std::size_t channels() const { return (has_color ? 4u : 0u) + (has_scalar ? 1u : 0u); }
};

VertexAttributes read_attributes(const MeshView& view, const MeshArrays& mesh);

/// Writes them back; cannot fail. A scalar that the caller's own type could not hold stays as it was.
void commit_attributes(const MeshArrays& mesh, const VertexAttributes& attributes, const MeshView& view);

}  // namespace vcg_core::detail
