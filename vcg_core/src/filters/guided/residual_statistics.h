// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "mesh_arrays.h"
#include "ring_means.h"

namespace vcg_core::detail {

/// What a filter has removed from a mesh.
struct Residual {
  Array<double> height;             ///< by vertex: along the normal
  const Array<std::uint8_t>& seen;  ///< by vertex: whether it was free to move; others do not count
};

/// How a residual r is spread over the mesh and its waves.
struct ResidualSpread {
  /// Standard deviation of the energy of r around a vertex, some seven edges wide, over its mean.
  double unevenness = 0;
  /// Share of the variance that is left after a low-pass over some six edges.
  double wide = 0;
};

/// What tells noise from shape in a residual r. All 0 where r is 0 everywhere.
struct ResidualStatistics {
  double variance = 0;     ///< mean of r^2
  double skewness = 0;     ///< mean of r^3 over that of r^2 to the power of 3/2
  double kurtosis = 0;     ///< mean of r^4 over that of r^2 squared
  double correlation = 0;  ///< of a vertex with the mean of its ring
  ResidualSpread spread;
};

ResidualStatistics statistics_of(const RingMeans& rings, const Residual& residual, Job& job);

/// The spread that white noise on this mesh has when it has been low-passed until its correlation is the given one.
/// Always the same.
ResidualSpread spread_of_noise(const RingMeans& rings, const Array<std::uint8_t>& seen, double correlation, Job& job);

}  // namespace vcg_core::detail
