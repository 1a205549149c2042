// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lowest_bit.h"
#include "patch.h"

namespace vcg_core::detail {
namespace {

/// Ranks by a distance, in buckets: the smallest next, and within a bucket the one that came last. The buckets are used
/// in turn: those that the smallest distance has passed serve again for larger ones, so that they stay narrow whatever
/// the limit.
class DistanceQueue {
 public:
  static constexpr std::uint32_t nothing = 0xffffffff;

  /// @param limit  the largest distance that matters
  DistanceQueue(const PatchGroup& group, float limit)
      : q_(group.queue), buckets_per_unit_(queue_buckets / (limit < most_at_once ? limit : most_at_once)) {
    for (std::uint32_t rank = 0; rank < group.rows; ++rank) q_.bucket_of[rank] = nothing;
    for (std::uint32_t slot = 0; slot < queue_buckets; ++slot) q_.first[slot] = nothing;
  }

  /// Puts a rank in; where it is in already, the smaller distance counts.
  void add(std::uint32_t rank, float distance) {
    const std::uint32_t bucket = bucket_at(distance);
    if (q_.bucket_of[rank] != nothing) {
      if (q_.bucket_of[rank] <= bucket) return;
      take(rank);
    }
    const std::uint32_t slot = bucket % queue_buckets;
    const std::uint32_t next = q_.first[slot];
    if (next != nothing) q_.previous[next] = rank;
    q_.bucket_of[rank] = bucket;
    q_.previous[rank] = nothing;
    q_.next[rank] = next;
    q_.first[slot] = rank;
    occupied_[slot / 64] |= std::uint64_t(1) << (slot % 64);
  }

  /// Takes out a rank of the smallest distance; `nothing` if there is none.
  std::uint32_t pop() {
    std::uint64_t bits = occupied_[lowest_ % queue_buckets / 64] & (~std::uint64_t(0) << (lowest_ % 64));
    for (std::uint32_t word = 0; bits == 0; bits = occupied_[lowest_ % queue_buckets / 64]) {
      if (word++ == words) return nothing;
      lowest_ = lowest_ / 64 * 64 + 64;
    }
    lowest_ = lowest_ / 64 * 64 + lowest_bit(bits);
    const std::uint32_t rank = q_.first[lowest_ % queue_buckets];
    take(rank);
    return rank;
  }

  /// Up to this distance ranks are in the bucket that comes next.
  float smallest() const { return static_cast<float>(lowest_ + 1) / buckets_per_unit_; }

 private:
  static constexpr std::uint32_t words = queue_buckets / 64;
  static constexpr float most_at_once = 100;  // |e|: a bucket is a tenth of an edge, and no edge that matters as long

  std::uint32_t bucket_at(float distance) const {
    const float place = distance * buckets_per_unit_;
    const std::uint32_t last = lowest_ + queue_buckets - 1;
    if (!(place < static_cast<float>(last))) return last;
    const auto bucket = static_cast<std::uint32_t>(place);
    return bucket < lowest_ ? lowest_ : bucket;
  }

  void take(std::uint32_t rank) {
    const std::uint32_t slot = q_.bucket_of[rank] % queue_buckets;
    const std::uint32_t next = q_.next[rank];
    const std::uint32_t previous = q_.previous[rank];
    if (next != nothing) q_.previous[next] = previous;
    if (previous != nothing)
      q_.next[previous] = next;
    else
      q_.first[slot] = next;
    if (q_.first[slot] == nothing) occupied_[slot / 64] &= ~(std::uint64_t(1) << (slot % 64));
    q_.bucket_of[rank] = nothing;
  }

  const QueueMemory& q_;
  float buckets_per_unit_;
  std::uint32_t lowest_ = 0;  ///< no bucket below has a rank
  std::uint64_t occupied_[words] = {};
};

}  // namespace
}  // namespace vcg_core::detail
