// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "mesh_arrays.h"
#include "patch.h"

namespace vcg_core::detail {

/// A face as seen from a vertex v of it.
struct RingFace {
  Index next;                     ///< the vertex that follows v in the face
  Index previous;                 ///< the vertex that precedes it
  std::uint8_t slot_at_next;      ///< place of the face among those of `next`; most_face_bits if that is a hub
  std::uint8_t slot_at_previous;  ///< the same for `previous`
};

/// The faces of all vertices in the order of MeshTopology::star, as the march asks for them. Depends on the
/// connectivity only. Spelled out on demand: the faces of near vertices lie close in memory, and a list of them would
/// be the largest array of all.
class Rings {
 public:
  /// @param mesh  referred to
  Rings(const MeshArrays& mesh, Array<std::array<std::uint8_t, 3>> slot) : mesh_(&mesh), slot_(std::move(slot)) {}

  RingFace operator[](Index s) const {
    const Index corner = mesh_->topology.star[s];
    const Index f = corner / 3, k = corner - 3 * f;
    const Index next = k == 2 ? 0 : k + 1, previous = k == 0 ? 2 : k - 1;
    const auto& face = mesh_->face[f];
    const auto& slot = slot_[f];
    return {face[next], face[previous], slot[next], slot[previous]};
  }

 private:
  const MeshArrays* mesh_;
  Array<std::array<std::uint8_t, 3>> slot_;  ///< by face: its place among the faces of each of its vertices
};

Rings make_rings(const MeshArrays& mesh, Job& job);

}  // namespace vcg_core::detail
