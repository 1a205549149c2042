// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/errors.h>
#include <vcg_core/mesh/mesh_view.h>
#include <vcg_core/method.h>
#include <vcg_core/progress.h>
#include <vcg_core/smoothing_limits.h>
#include <vcg_core/smoothing_parameters.h>
#include <vcg_core/smoothing_report.h>

namespace vcg_core {

/// Smooths the mesh in place: moves vertices, changes nothing else but colours and scalars on request. All or nothing.
/// Single precision in, single precision out; the arithmetic is the same. docs/algorithm.md holds the equations and
/// where the code differs from the paper.
///
/// @return  what was done, lengths in the mesh's unit
/// @throws InvalidParameter, InvalidMesh (no faces, too many vertices or faces, a coordinate that is not finite, an
///         index that is no vertex's, no edge of any length), Cancelled; the mesh is then bit for bit as it was
SmoothingReport smooth(const MeshView& mesh, Method method, const SmoothingParameters& parameters = {},
                       const Progress& progress = {}, const SmoothingLimits& limits = {});

}  // namespace vcg_core
