// SPDX-License-Identifier: GPL-3.0-or-later
#include "group_order.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace vcg_core::detail {

const PatchGroup& GroupOrder::of(const Patch& patch, const std::uint32_t* source_row, std::uint32_t sources,
                                 const GroupBall& ball, float reach) {
  group_.sources = sources;
  group_.source_row = source_row;
  select_near_rows(patch, ball, reach);
  sort_by_radius(patch.rows);
  group_.inner_rows = 0;
  for (std::uint32_t lane = 0; lane < sources; ++lane)
    group_.inner_rows = std::max(group_.inner_rows, rank_of_[source_row[lane]] + 1);
  return group_;
}

/// Those inside the ball around the group, as far as they are near one of its sources.
void GroupOrder::select_near_rows(const Patch& patch, const GroupBall& ball, float reach) {
  const float squared_reach = (ball.radius + reach) * (ball.radius + reach);
  near_.resize(patch.rows);
  squared_radius_of_near_.resize(patch.rows);
  for (std::uint32_t row = 0; row < patch.rows; ++row) {
    const float x = patch.place[0][row] - ball.middle[0];
    const float y = patch.place[1][row] - ball.middle[1];
    const float z = patch.place[2][row] - ball.middle[2];
    squared_radius_of_near_[row] = x * x + y * y + z * z;
  }
  std::size_t count = 0;  // without branches: which rows are near is unpredictable
  for (std::uint32_t row = 0; row < patch.rows; ++row) {
    const float squared = squared_radius_of_near_[row];
    near_[count] = row;
    squared_radius_of_near_[count] = squared;
    count += squared <= squared_reach ? 1 : 0;
  }
  count = within_reach_(patch, group_, reach, static_cast<std::uint32_t>(count), near_.data(),
                        squared_radius_of_near_.data());
  near_.resize(count);
  squared_radius_of_near_.resize(count);
}

/// In buckets of equal area, and as they come inside them.
void GroupOrder::sort_by_radius(std::uint32_t patch_rows) {
  constexpr float buckets_per_squared_edge = 4;  // a few rows each
  constexpr float most_buckets = 8192;           // what stays in the first-level cache
  const std::size_t n = near_.size();
  float largest = 0;
  for (const float squared : squared_radius_of_near_) largest = std::max(largest, squared);
  const float scale =
      largest * buckets_per_squared_edge < most_buckets ? buckets_per_squared_edge : most_buckets / largest;
  const auto bucket = [&](std::size_t i) { return static_cast<std::size_t>(squared_radius_of_near_[i] * scale); };
  bucket_begin_.assign(static_cast<std::size_t>(largest * scale) + 2, 0);
  for (std::size_t i = 0; i < n; ++i) ++bucket_begin_[bucket(i) + 1];
  std::partial_sum(bucket_begin_.begin(), bucket_begin_.end(), bucket_begin_.begin());
  rank_of_.assign(patch_rows, not_near);
  row_at_.resize(n);
  squared_radius_.resize(n);
  dirty_.resize(n / 64 + 1);
  queue_.resize(queue_buckets + 4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t rank = bucket_begin_[bucket(i)]++;
    rank_of_[near_[i]] = rank;
    row_at_[rank] = near_[i];
    squared_radius_[rank] = squared_radius_of_near_[i];
  }
  group_.rows = static_cast<std::uint32_t>(n);
  group_.row_at = row_at_.data();
  group_.rank_of = rank_of_.data();
  group_.squared_radius = squared_radius_.data();
  group_.dirty = dirty_.data();
  std::uint32_t* const queue = queue_.data();
  group_.queue = {queue, queue + queue_buckets, queue + queue_buckets + n, queue + queue_buckets + 2 * n,
                  queue + queue_buckets + 3 * n};
}

}  // namespace vcg_core::detail
