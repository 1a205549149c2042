// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lane_queue.h"
#include "lane_state.h"

namespace vcg_core::detail {
namespace {

/// The march for neighbourhoods that are large, bend, or have hubs: as Dijkstra's algorithm, from the sources on, the
/// row next that may have the smallest distance in a lane. A row that improves makes the faces around it pending at
/// those of their vertices that may gain by it, each with the bound of what it may gain as its distance in the queue.
///
/// A hub (see is_hub) has no pending faces. What improves beside it is looked at from it at once, by that one face, and
/// where it improves itself it waits in the queue to make faces pending as other rows do. So a hub of N faces costs N
/// looks when it has improved, and one look for each change beside it.
class Spread : MarchState {
 public:
  Spread(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, LanePoll poll, void* context)
      : MarchState(patch, group, parameters, poll, context), queue_(group, parameters.limit) {
    const std::uint64_t corners = patch.face_begin[patch.rows];
    enough_looks_ = corners * parameters.looks_per_corner;
    eager_looks_ = 4 * corners;  // twice what fans need
    further_looks_ = enough_looks_ / 4 + 1;
  }

  void run() {
    for (std::uint32_t rank = 0; rank < g_.rows; ++rank) g_.queue.improved[rank] = 0;
    for (std::uint32_t lane = 0; lane < g_.sources; ++lane) leave(g_.source_row[lane]);
    for (std::uint32_t rank; (rank = queue_.pop()) != DistanceQueue::nothing;) {
      if (looks_ > enough_looks_) loosen();
      const std::uint32_t row = g_.row_at[rank];
      Vector gained;
      if (p_.pending[row] != 0 && improve(row, take_pending(row), gained)) {
        g_.queue.improved[rank] = 1;
        const float distance = Simd::lowest(gained);
        if (looks_ > eager_looks_ && distance > queue_.smallest()) {
          queue_.add(rank, distance);
          continue;
        }
      }
      if (g_.queue.improved[rank] == 0) continue;
      g_.queue.improved[rank] = 0;
      leave(row);
    }
  }

  std::uint64_t looks() const { return looks_; }
  bool loosened() const { return loosened_; }

 private:
  void loosen() {
    double_tolerance();
    enough_looks_ = looks_ + further_looks_;
    loosened_ = true;
  }

  std::uint32_t take_pending(std::uint32_t row) {
    const std::uint32_t faces = p_.pending[row];
    p_.pending[row] = 0;
    return faces;
  }

  /// Makes the faces around a row pending at their two other vertices, where these may gain.
  void leave(std::uint32_t row) {
    count_looks(p_.face_begin[row + 1] - p_.face_begin[row]);
    const Vector from = Simd::load(at(row));
    for (std::uint32_t f = p_.face_begin[row]; f < p_.face_begin[row + 1]; ++f) {
      if (!is_near(p_.row_1[f]) || !is_near(p_.row_2[f])) continue;
      const auto [of_row_1, of_row_2] = gains(f, from);
      if (of_row_1.any()) make_pending(f, p_.row_1[f], p_.marks[f].of_row_1, of_row_1);
      if (of_row_2.any()) make_pending(f, p_.row_2[f], p_.marks[f].of_row_2, of_row_2);
    }
  }

  bool is_near(std::uint32_t row) const { return g_.rank_of[row] != not_near; }

  void make_pending(std::uint32_t f, std::uint32_t row, std::uint32_t mark, const Gain& gain) {
    if (is_hub(p_, row)) return offer_to_hub(f, row);
    p_.pending[row] |= mark;
    queue_.add(g_.rank_of[row], Simd::lowest(gain.in_lanes()));
  }

  /// Lowers the distances of a hub by a face that is at hand as another vertex, its apex, sees it.
  void offer_to_hub(std::uint32_t f, std::uint32_t hub) {
    count_looks(1);
    const std::uint32_t apex = p_.apex[f];
    const std::uint32_t other = hub == p_.row_1[f] ? p_.row_2[f] : p_.row_1[f];
    Nearest nearest;
    nearest.look_at(Simd::load(at(apex)), Simd::load(at(other)),
                    shape_of(at_row(p_.place, apex), at_row(p_.place, other), at_row(p_.place, hub)));
    Vector gained;
    if (!store(hub, Simd::load(at(hub)), nearest.distance(), gained)) return;
    g_.queue.improved[g_.rank_of[hub]] = 1;
    queue_.add(g_.rank_of[hub], Simd::lowest(gained));
  }

  DistanceQueue queue_;
  std::uint64_t eager_looks_;    ///< up to here an improved row does not wait for its turn
  std::uint64_t enough_looks_;   ///< with the present tolerance
  std::uint64_t further_looks_;  ///< with each larger one
  bool loosened_ = false;
};

}  // namespace
}  // namespace vcg_core::detail
