// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "outline.h"
#include "patch.h"

namespace mesh_tools::shapes {

/// The vertices that sample an outline at one height, in its direction.
struct Ring {
  struct Sample {
    int vertex;
    double length;  ///< arc length within the run
  };
  const Outline* outline;
  double height;
  /// One list for each smooth run, from its first point to its last, both included; the last vertex of a run is the
  /// first of the next.
  std::vector<std::vector<Sample>> runs;
};

/// Samples `outline` at `height`; the outline must outlive the ring.
Ring add_ring(SurfaceBuilder& builder, const Outline& outline, double height);

/// The vertical wall between two rings of the same outline; the outside is to the outline's right.
void add_wall(SurfaceBuilder& builder, const Ring& lower, const Ring& upper, double smallest_spacing);

/// The horizontal face that the rings enclose, seen from above or from below.
enum class Facing { up, down };
void add_cap(SurfaceBuilder& builder, const std::vector<const Ring*>& rings, Facing facing, double smallest_spacing);

}  // namespace mesh_tools::shapes
