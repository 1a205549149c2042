// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace vcg_core {

/// What holds a smoothing filter back, whichever it is. Lengths are in the mesh's own unit, not in |e|.
struct SmoothingLimits {
  /// Vertices at most this far apart are one vertex of the surface, and so are those that a chain of such steps joins;
  /// >= 0. 0: only those at exactly the same place. The joined vertices keep their distances: each moves by what the
  /// first of them in the order of space moves by. Joining may leave faces without area, but deletes nothing.
  double weld_distance = 0;
  /// No vertex moves farther from where it was, up to the rounding of the coordinates; >= 0. 0: nothing moves at all.
  double max_displacement = std::numeric_limits<double>::infinity();

  /// Throws InvalidParameter with the name, the value and the allowed range of the first that is out of range.
  void validate() const;
};

}  // namespace vcg_core
