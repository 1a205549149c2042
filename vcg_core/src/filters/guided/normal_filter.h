// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "face_lists.h"
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Weights within a list, in 65535ths of the list's largest: only their ratios have a meaning, and those of less than
/// this, a sliver's own among them, are 0.
using ListWeights = Array<std::uint16_t>;

/// The filter's weights that depend on places only: for each entry of `within` area times closeness,
/// A_j exp(-|c_i - c_j|^2 / (2 (closeness spacing_i)^2)).
/// @param area  of the faces for vertices at `position`
ListWeights closeness_weights(const FaceLists& within, const MeshArrays& mesh, const Array<Vec3>& position,
                              const Array<double>& area, const Array<double>& spacing, double closeness, Job& job);

/// One step of joint bilateral filtering of normals: n_i' is the direction of the sum over the neighbourhood of
/// n_j weight_ij exp(-|g_i - g_j|^2 / (2 range_sigma^2)). With the normals themselves as guide g it is the bilateral
/// filter of Zheng, Fu, Au, Tai: Bilateral normal filtering for mesh denoising, 2011; with another guide that of Zhang
/// et al. 2015. The range sigma is a length of differences of unit normals. Where the sum has no
/// direction, the normal stays.
/// @tparam Normal  UnitNormal or PackedNormal
template <class Normal>
Array<Normal> filter_normals(const FaceLists& within, const ListWeights& weight, const Array<Normal>& guide,
                             const Array<Normal>& normal, double range_sigma, Job& job);

/// The same without a guide: the direction of the sum of n_j weight_ij.
template <class Normal>
Array<Normal> mean_of_neighbourhoods(const FaceLists& within, const ListWeights& weight, const Array<Normal>& normal,
                                     Job& job);

}  // namespace vcg_core::detail
