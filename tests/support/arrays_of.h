// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <job.h>
#include <mesh_arrays.h>
#include <support/flat_mesh.h>

namespace test_support {

/// The mesh as the algorithms see it, at its own scale: for tests of their steps.
inline vcg_core::detail::MeshArrays arrays_of(const FlatMesh& flat, vcg_core::detail::Job& job) {
  using vcg_core::detail::Index;
  vcg_core::detail::RawMesh raw;
  for (const Point& p : flat.points) raw.position.emplace_back(p[0], p[1], p[2]);
  for (const Triangle& f : flat.faces)
    raw.face.push_back({static_cast<Index>(f[0]), static_cast<Index>(f[1]), static_cast<Index>(f[2])});
  for (Index v = 0; v < raw.position.size(); ++v) raw.host_vertex.push_back(v);
  raw.selected.assign(raw.position.size(), 0);
  raw.host_vertex_count = raw.position.size();
  return make_mesh_arrays(std::move(raw), job);
}

}  // namespace test_support
