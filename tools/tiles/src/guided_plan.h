// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <vcg_core/mesh/guided_whole.h>
#include <vcg_core/smoothing_parameters.h>

#include "large_mesh.h"
#include "plan.h"
#include "stage.h"

namespace tiles {

/// So many vertices are in memory at once at least when the medians are measured.
constexpr std::size_t usual_sample = 30000;

/// What the guided filter has to know of the whole mesh, from pieces of it: the grid of voxels if there is one, the
/// noise, and the medians of its rounds. Has at most a piece in memory, or `sample_vertices` vertices; uses a file in
/// the plan's folder for the noise of each vertex.
/// @param plan  its cut is done, its buckets are there, and |e| is known
vcg_core::GuidedWhole measure_guided(const LargeMesh& mesh, const Plan& plan, std::size_t sample_vertices,
                                     const Stage& stage);

/// How far, in |e|, the guided filter's result at a vertex depends on others so that it is seen: see
/// docs/large-meshes.md.
double guided_reach(const vcg_core::SmoothingParameters& parameters);

}  // namespace tiles
