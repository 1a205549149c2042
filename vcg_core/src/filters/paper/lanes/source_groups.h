// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Vertices in groups of up to `lanes` that lie close together: group g is member[begin[g]] to member[begin[g + 1]].
struct SourceGroups {
  Array<Index> member;
  Array<Index> begin;

  std::size_t size() const { return begin.size() - 1; }
};

/// Groups the vertices that have faces, growing each group along the mesh from the lowest vertex left.
SourceGroups group_sources(const MeshArrays& mesh, std::uint32_t lanes, Job& job);

/// Runs of groups that lie close together and so need nearly the same vertices, one patch for each: run p is the groups
/// begin[p] to begin[p + 1]. Close, as a patch's places are single precision relative to its middle.
Array<Index> patch_groups(const SourceGroups& groups, const MeshArrays& mesh);

}  // namespace vcg_core::detail
