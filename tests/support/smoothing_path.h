// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vcg_core/smoothing_parameters.h>

namespace test_support {

/// One way through the library's filter, and how close to the exact result it is to come. The only place for
/// tolerances that depend on the way.
struct SmoothingPath {
  std::string name;

  /// Parameters with which the library takes this way.
  vcg_core::SmoothingParameters parameters;

  /// Largest difference of a position from the same formula in exact arithmetic, in |e|, as long as the neighbourhood
  /// is the same.
  double position_tolerance;

  /// What rounding leaves of an offset whose exact value is 0, in |e|, on a mesh of some ten edges across.
  double rounding;

  /// A distance this near to the cut-off, in |e|, may fall on either side of it.
  double clearance;

  /// Share of the vertices whose neighbourhood may come out otherwise when the mesh is turned, shifted or shuffled:
  /// their distances lie as near to the cut-off as rounding reaches.
  double ambiguous_share;
};

/// All ways. Tests of the filter go over each.
const std::vector<SmoothingPath>& smoothing_paths();

/// The way's name as the name of an instance of a test.
std::string name_of_path(const testing::TestParamInfo<SmoothingPath>& info);

/// For GoogleTest's messages.
std::ostream& operator<<(std::ostream& out, const SmoothingPath& path);

}  // namespace test_support
