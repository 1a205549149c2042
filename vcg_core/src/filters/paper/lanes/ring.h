// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <vcg_core/detail/mesh_arrays.h>

#include "patch.h"

namespace vcg_core::detail {

/// A face as seen from a vertex v of it.
struct RingFace {
  Index next;                     ///< the vertex that follows v in the face
  Index previous;                 ///< the vertex that precedes it
  std::uint8_t slot_at_next;      ///< place of the face among those of `next`; most_face_bits if that is a hub
  std::uint8_t slot_at_previous;  ///< the same for `previous`
};

/// The faces of all vertices in the order of MeshTopology::star, with what the march asks of them spelled out. Depends
/// on the connectivity only.
Array<RingFace> make_rings(const MeshArrays& mesh, Job& job);

}  // namespace vcg_core::detail
