// SPDX-License-Identifier: GPL-3.0-or-later
#include "freed_blocks.h"

#include <algorithm>
#include <iterator>
#include <new>

namespace vcg_core::detail {

void* FreedBlocks::take(std::size_t bytes) noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  used_bytes_ += bytes;
  most_used_bytes_ = std::max(most_used_bytes_, used_bytes_);
  auto best = waiting_.end();
  for (auto block = waiting_.begin(); block != waiting_.end(); ++block)
    if (block->second >= bytes && (best == waiting_.end() || block->second < best->second)) best = block;
  char* found = nullptr;
  if (best != waiting_.end()) {  // its end, so that the rest keeps its place in the map
    best->second -= bytes;
    waiting_bytes_ -= bytes;
    found = best->first + best->second;
    if (best->second == 0) waiting_.erase(best);
  }
  shrink_to(most_used_bytes_ - used_bytes_);
  return found;
}

void FreedBlocks::give_up(std::size_t bytes) noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  used_bytes_ -= bytes;
}

void FreedBlocks::give(void* begin, std::size_t bytes) noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  used_bytes_ -= bytes;
  if (begun_ > 0) {
    try {
      return add(static_cast<char*>(begin), bytes);
    } catch (const std::bad_alloc&) {  // then it does not wait
    }
  }
  unmap_pages_(begin, bytes);
}

bool FreedBlocks::release() noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool any = !waiting_.empty();
  shrink_to(0);
  return any;
}

void FreedBlocks::begin() noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (begun_++ == 0) most_used_bytes_ = used_bytes_;
}

void FreedBlocks::end() noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (--begun_ == 0) shrink_to(0);
}

/// Joins it with those that adjoin it.
void FreedBlocks::add(char* begin, std::size_t bytes) {
  auto block = waiting_.emplace(begin, bytes).first;
  waiting_bytes_ += bytes;
  const auto next = std::next(block);
  if (next != waiting_.end() && begin + bytes == next->first) {
    block->second += next->second;
    waiting_.erase(next);
  }
  if (block == waiting_.begin()) return;
  const auto previous = std::prev(block);
  if (previous->first + previous->second != begin) return;
  previous->second += block->second;
  waiting_.erase(block);
}

/// The smallest blocks go first: they serve the fewest arrays.
void FreedBlocks::shrink_to(std::size_t bytes) noexcept {
  while (waiting_bytes_ > bytes) {
    const auto smallest = std::min_element(waiting_.begin(), waiting_.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
    const std::size_t gone = std::min(smallest->second, waiting_bytes_ - bytes);
    smallest->second -= gone;
    waiting_bytes_ -= gone;
    unmap_pages_(smallest->first + smallest->second, gone);
    if (smallest->second == 0) waiting_.erase(smallest);
  }
}

}  // namespace vcg_core::detail
