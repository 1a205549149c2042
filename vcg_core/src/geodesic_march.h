// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "mesh_arrays.h"
#include "virtual_start.h"

namespace vcg_core::detail {

/// Fast marching from one vertex, section 4.1: settles vertices in the order of their distance and computes the third
/// vertex of each face by its virtual start point. Label-correcting: a settled vertex is opened again when a face
/// improves it by more than a tolerance. The three-case rule never falls when a given distance rises, so the result
/// does not depend on the order; without a tolerance rounding would reopen vertices nearly forever.
///
/// The readable, scalar path. Work memory is proportional to the mesh and reused from run to run.
///
/// @tparam Scalar  double for neighbourhoods; long double for single-source distances, which then come out of hundreds
///                 of steps correctly rounded to double wherever long double is the wider type
/// @tparam Frames  gives the TriangleFrame of each corner: all kept, as many sources need them, or FramesOnDemand
template <class Scalar, class Frames = Array<TriangleFrame<Scalar>>>
class GeodesicMarch {
 public:
  GeodesicMarch(const MeshArrays& mesh, const Frames& frames, Scalar tolerance);

  /// Finds the distances from `source` of all vertices up to `limit`; farther ones may be reached, and are then given
  /// a distance that is too large. `poll` is called now and then with the number of vertices settled so far.
  void run(Index source, Scalar limit, const std::function<void(std::size_t settled)>& poll);

  /// The vertices reached by the last run, the source first.
  const Array<Index>& reached() const { return reached_; }
  Scalar distance(Index v) const { return distance_[v]; }

 private:
  enum class State : std::uint8_t { unseen, open, settled };

  void offer(Index v, Scalar distance);
  void settle(Index v);
  void clear();

  const MeshArrays& mesh_;
  const Frames& frames_;
  Scalar tolerance_;
  std::vector<Scalar> distance_;
  std::vector<State> state_;
  Array<Index> reached_;
  using Entry = std::pair<Scalar, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front_;
};

}  // namespace vcg_core::detail
