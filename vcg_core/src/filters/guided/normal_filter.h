// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "face_geometry.h"
#include "face_neighborhoods.h"
#include "mesh_arrays.h"
#include "unit_normals.h"

namespace vcg_core::detail {

/// The filter's weights that depend on places only: for each entry of `within` area times closeness,
/// A_j exp(-|c_i - c_j|^2 / (2 (closeness spacing_i)^2)).
Array<float> closeness_weights(const FaceLists& within, const FaceGeometry& faces, const Array<double>& spacing,
                               double closeness, Job& job);

/// One step of joint bilateral filtering of normals: n_i' is the direction of the sum over the neighbourhood of
/// n_j weight_ij exp(-|g_i - g_j|^2 / (2 range_sigma^2)). With the normals themselves as guide g it is the bilateral
/// filter of Zheng, Fu, Au, Tai: Bilateral normal filtering for mesh denoising, 2011; with another guide that of Zhang
/// et al. 2015. The range sigma is a length of differences of unit normals. Where the sum has no
/// direction, the normal stays.
Array<UnitNormal> filter_normals(const FaceLists& within, const Array<float>& weight, const Array<UnitNormal>& guide,
                                 const Array<UnitNormal>& normal, double range_sigma, Job& job);

/// The same without a guide: the direction of the sum of n_j weight_ij.
Array<UnitNormal> mean_of_neighbourhoods(const FaceLists& within, const Array<float>& weight,
                                         const Array<UnitNormal>& normal, Job& job);

}  // namespace vcg_core::detail
