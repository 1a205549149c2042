// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"
#include "noise_estimate.h"
#include "residual_statistics.h"

namespace vcg_core::detail {

/// Looks for noise that is correlated over some edges, by a trial run of the filter on a mesh on which estimate_noise()
/// has found none. The same for all vertices; 0 if there is no such noise, or less than two thousand vertices.
///
/// Such noise agrees from vertex to vertex as shape does, so estimate_noise() takes it for shape. But what a filter
/// that keeps edges removes from a noisy mesh is the same kind of thing everywhere, and what it removes from a clean
/// one lies where the details are. In the line of the method noise of Buades, Coll, Morel, 2005; how it is judged is
/// new here.
NoiseEstimate find_correlated_noise(const PassInput& input);

/// The same where all vertices with faces may move.
double correlated_noise_of(const MeshArrays& mesh, Job& job);

/// How far a residual is noise, from 0 to 1, when `noise` is the spread that low-passed white noise of the same
/// correlation would be on the same mesh. The product of four factors:
///
/// - kurtosis is 3 for noise; details are few and high, waves and threads too regular;
/// - skewness is 0 for noise; details stand out to one side;
/// - the energy of noise is uneven by chance only;
/// - a wide low-pass leaves less of it than half of what it leaves of noise, as the filter leaves wide waves on the
/// mesh,
///   but not what is wide about details.
double trust_in(const ResidualStatistics& residual, const ResidualSpread& noise);

}  // namespace vcg_core::detail
