// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "../coarse_result.h"
#include "../packed_normal.h"
#include "../unit_normals.h"
#include "mesh_arrays.h"
#include "packed_number.h"

namespace vcg_core::detail {

/// What the blend of normals chooses from and what it sees: by face.
struct Candidates {
  std::vector<Array<PackedNormal>> normal;  ///< differently filtered; those of faces without area may be zero
  /// Spread of normals around the face, noise, spacing and differences around it.
  std::vector<Array<PackedNumber>> scalar;

  std::size_t size() const { return normal.size(); }
};

/// The candidates of the first stage: the normals of the noisy faces; those after the coarse rounds; the latter after 4
/// and after 16 fine rounds; the noisy ones averaged over the neighbourhood once and three times, without and with the
/// finest ones as guide; and those of band-limited positions. Frees the coarse positions and faces, which nothing else
/// needs.
Candidates first_candidates(CoarseResult& coarse, Job& job);

/// Median distance of the noisy vertices from the coarse ones along the normal, over the whole mesh: the next one of
/// the medians. first_candidates() asks for it.
double median_residual(const CoarseResult& coarse, Job& job);

/// The candidates of the second stage, which refines the blend of the first one.
/// @param first_blend  by face
Candidates second_candidates(const CoarseResult& coarse, Array<UnitNormal> first_blend, Job& job);

/// Which candidate of a stage stands in where a blend has no direction.
constexpr std::size_t safe_candidate = 1;

}  // namespace vcg_core::detail
