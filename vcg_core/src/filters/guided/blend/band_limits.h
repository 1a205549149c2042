// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Displacements of the vertices by low-passes of their positions, one array for each cut-off.
///
/// W takes the mean over the ring, on creases over the two neighbours along the crease. A wave of length L edges on a
/// regular mesh has the eigenvalue cos(4.44 / L) of W. The low-pass multiplies that of cos(theta) by a step that falls
/// from 1 to 0 at the cut-off, blurred by a normal distribution with a standard deviation of a third of the cut-off. It
/// is a polynomial in W, summed by Chebyshev's recursion; all cut-offs share one recursion.
///
/// Source: Taubin, Zhang, Golub: Optimal surface smoothing as filter design, 1996, with the normal distribution in
/// place of Hamming's window: its step does not ring.
/// @param cut_offs  theta, above 0 and below pi
std::vector<Array<Eigen::Vector3f>> band_limit_displacements(const MeshArrays& mesh, const Array<Vec3>& position,
                                                             const std::vector<double>& cut_offs, Job& job);

/// The coefficients of Chebyshev's polynomials, from that of T_0 on; their sum is 1, so that the mean stays.
std::vector<double> band_limit_coefficients(double cut_off);

}  // namespace vcg_core::detail
