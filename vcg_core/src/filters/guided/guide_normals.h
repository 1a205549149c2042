// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "face_geometry.h"
#include "guided_settings.h"
#include "mesh_arrays.h"
#include "unit_normals.h"
#include "whole_medians.h"

namespace vcg_core::detail {

/// A guide for each face: what its normal is like when noise is averaged away and edges are not.
///
/// Source: Zhang, Deng, Zhang, Bouaziz, Liu: Guided mesh normal filtering, 2015, section 3: of the patches that hold
/// the face (each the faces around one face), the one with the most consistent normals lends its mean normal. New here:
/// the patch is trusted only if its normals spread no wider than those of most other best patches. Where all patches
/// reach over an edge, as on parts one edge length thick, the guide is a bilateral mean over the faces around.
/// @param across   as faces_across() finds them
/// @param faces    filtered so far
/// @param medians  its next two are those of the spread and of the jumps
Array<UnitNormal> guide_normals(const MeshArrays& mesh, const Array<Index>& across, const FaceGeometry& faces,
                                const GuidedSettings& settings, WholeMedians& medians, Job& job);

}  // namespace vcg_core::detail
