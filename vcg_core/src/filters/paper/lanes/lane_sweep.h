// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <math.h>

#include "lane_state.h"
#include "lowest_bit.h"

namespace vcg_core::detail {
namespace {

/// The march for neighbourhoods of the usual size: rows are computed outwards, from the faces behind the front; at once
/// these faces are looked at from their two other vertices as well. When a row improves that the front has passed, the
/// faces around it become pending at their other vertices; rows with pending faces are computed again, the lowest
/// first, a little behind the front: label-correcting, with errors mended before they spread.
///
/// That is fast as long as rows come nearly in the order of their distance, for all lanes. Where the surface bends
/// within reach they do not, and the march goes back and forth: so it gives up when it has looked too often.
///
/// The patch must have no hubs.
class Sweep : MarchState {
 public:
  using MarchState::MarchState;

  /// Whether it came to its end.
  bool run() {
    for (std::uint32_t word = 0; word <= g_.rows / 64; ++word) g_.dirty[word] = 0;
    return settle_inner() && sweep_outwards();
  }

  std::uint64_t looks() const { return looks_; }

 private:
  /// Twice what a scan's smallest neighbourhoods take, and more where there is little to lose.
  bool too_many_looks() const { return looks_ > 4096 + std::uint64_t(20) * g_.rows; }

  /// Among the sources no order suits all lanes: all rows there are swept up, down and up, which leaves little, and
  /// then those with pending faces until nothing improves.
  bool settle_inner() {
    front_ = g_.inner_rows;
    for (std::uint32_t rank = 0; rank < g_.inner_rows; ++rank) lower(g_.row_at[rank], faces_behind(g_.row_at[rank]));
    for (std::uint32_t rank = g_.inner_rows; rank-- > 0;) lower(g_.row_at[rank], faces_behind(g_.row_at[rank]));
    for (std::uint32_t rank = 0; rank < g_.inner_rows; ++rank) renew(g_.row_at[rank], faces_behind(g_.row_at[rank]));
    while (any_inner_dirty()) {
      if (too_many_looks()) return false;
      for (std::uint32_t rank = g_.inner_rows; rank-- > 0;)
        if (take_dirty(rank)) renew_pending(g_.row_at[rank]);
      for (std::uint32_t rank = 0; rank < g_.inner_rows; ++rank)
        if (take_dirty(rank)) renew_pending(g_.row_at[rank]);
    }
    lowest_dirty_ = g_.inner_rows;
    return true;
  }

  bool any_inner_dirty() const {
    std::uint64_t any = 0;
    for (std::uint32_t word = 0; word <= g_.inner_rows / 64; ++word) any |= g_.dirty[word];
    return any != 0;
  }

  bool sweep_outwards() {
    constexpr float lag = 0.3f;          // |e|: nearer to the front most rows are going to improve once more
    constexpr std::uint32_t stride = 4;  // rows: looking for dirty ones costs as much as computing one
    std::uint32_t settled = 0;
    for (std::uint32_t rank = g_.inner_rows; rank < g_.rows; ++rank) {
      const std::uint32_t row = g_.row_at[rank];
      const std::uint32_t faces = faces_behind(row);
      lower(row, faces);
      front_ = rank + 1;
      look_back(row, faces);
      if (rank % stride != 0) continue;
      const float behind = ::sqrtf(g_.squared_radius[rank]) - lag;
      while (settled < rank && g_.squared_radius[settled] < behind * behind) ++settled;
      if (!clean_below(settled)) return false;
    }
    return clean_below(g_.rows);
  }

  /// Whether the front has passed both other vertices of a face.
  bool is_behind(std::uint32_t f) const {
    return (g_.rank_of[p_.row_1[f]] < front_) & (g_.rank_of[p_.row_2[f]] < front_);
  }

  /// The bits of the faces of a row that are behind the front.
  std::uint32_t faces_behind(std::uint32_t row) const {
    const std::uint32_t begin = p_.face_begin[row];
    const std::uint32_t end = p_.face_begin[row + 1];
    std::uint32_t faces = 0;
    for (std::uint32_t f = begin; f < end; ++f) faces |= static_cast<std::uint32_t>(is_behind(f)) << (f - begin);
    return faces;
  }

  /// The faces by which the front has reached a row may also lead to their other vertices, in some lanes.
  void look_back(std::uint32_t row, std::uint32_t faces) {
    const std::uint32_t begin = p_.face_begin[row];
    const Vector from = Simd::load(at(row));
    std::uint32_t looks = 0;
    for (; faces != 0; faces &= faces - 1) {
      ++looks;
      const std::uint32_t f = begin + lowest_bit(faces);
      const auto [of_row_1, of_row_2] = gains(f, from);
      if (of_row_1.any()) renew(p_.row_1[f], p_.marks[f].of_row_1);
      if (of_row_2.any()) renew(p_.row_2[f], p_.marks[f].of_row_2);
    }
    count_looks(looks);
  }

  /// Computes dirty rows of ranks below `end`, always the lowest one next, until there are none; false if it gave up.
  bool clean_below(std::uint32_t end) {
    while (true) {
      const std::uint32_t rank = next_dirty(end);
      if (rank >= end) break;
      if (too_many_looks()) return false;
      lowest_dirty_ = rank;
      take_dirty(rank);
      renew_pending(g_.row_at[rank]);
    }
    if (lowest_dirty_ < end) lowest_dirty_ = end;
    return true;
  }

  std::uint32_t next_dirty(std::uint32_t end) const {
    if (lowest_dirty_ >= end) return end;
    std::uint32_t word = lowest_dirty_ / 64;
    std::uint64_t bits = g_.dirty[word] & (~std::uint64_t(0) << (lowest_dirty_ % 64));
    while (bits == 0) {
      if (++word > (end - 1) / 64) return end;
      bits = g_.dirty[word];
    }
    return word * 64 + lowest_bit(bits);
  }

  void renew_pending(std::uint32_t row) {
    const std::uint32_t faces = p_.pending[row];
    p_.pending[row] = 0;
    renew(row, faces);
  }

  /// Lowers the distances of a row by some of its faces and passes that on, if a lane within the limit gains enough.
  void renew(std::uint32_t row, std::uint32_t faces) {
    Vector gained;
    if (improve(row, faces, gained)) pass_on(row);
  }

  /// Lowers the distances of a row by some of its faces.
  void lower(std::uint32_t row, std::uint32_t faces) {
    Simd::store(at(row), Simd::min(Simd::load(at(row)), look_at(row, faces).distance()));
  }

  /// Makes the faces around a row pending at their two other vertices, where the front has passed both.
  void pass_on(std::uint32_t row) {
    for (std::uint32_t f = p_.face_begin[row]; f < p_.face_begin[row + 1]; ++f) {
      const std::uint32_t row_1 = p_.row_1[f];
      const std::uint32_t row_2 = p_.row_2[f];
      const std::uint32_t rank_1 = g_.rank_of[row_1];
      const std::uint32_t rank_2 = g_.rank_of[row_2];
      if (rank_1 >= front_ || rank_2 >= front_) continue;
      p_.pending[row_1] |= p_.marks[f].of_row_1;
      p_.pending[row_2] |= p_.marks[f].of_row_2;
      make_dirty(rank_1);
      make_dirty(rank_2);
      const std::uint32_t lowest = rank_1 < rank_2 ? rank_1 : rank_2;
      if (lowest < lowest_dirty_) lowest_dirty_ = lowest;
    }
  }

  void make_dirty(std::uint32_t rank) { g_.dirty[rank / 64] |= std::uint64_t(1) << (rank % 64); }

  bool take_dirty(std::uint32_t rank) {
    const std::uint64_t bit = std::uint64_t(1) << (rank % 64);
    const bool was = (g_.dirty[rank / 64] & bit) != 0;
    g_.dirty[rank / 64] &= ~bit;
    return was;
  }

  std::uint32_t front_ = 0;         ///< ranks below have been reached
  std::uint32_t lowest_dirty_ = 0;  ///< no rank below is dirty
};

}  // namespace
}  // namespace vcg_core::detail
