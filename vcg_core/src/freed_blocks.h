// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <mutex>

namespace vcg_core::detail {

/// Blocks of memory that were freed and wait for the next arrays, as pages that the system has to clear anew take a
/// tenth of the guided filter's time. Blocks in use and waiting ones together never take more than those in use once
/// took alone, so that waiting adds nothing to the peak. For any number of threads.
class FreedBlocks {
 public:
  using UnmapPages = void (*)(void* begin, std::size_t bytes);

  /// @param unmap_pages  gives a part of one or more blocks back to the system
  explicit FreedBlocks(UnmapPages unmap_pages) : unmap_pages_(unmap_pages) {}

  /// A block of that size, whatever it holds, or null: then the caller asks the system for one.
  void* take(std::size_t bytes) noexcept;
  /// The caller has been refused the block that he asked for.
  void give_up(std::size_t bytes) noexcept;
  /// A block that is not used any longer.
  void give(void* begin, std::size_t bytes) noexcept;
  /// Unmaps all that wait; whether there were any.
  bool release() noexcept;

  /// Blocks wait between a begin and its end only; several may overlap.
  void begin() noexcept;
  void end() noexcept;

 private:
  using Waiting = std::map<char*, std::size_t>;  ///< bytes by address; no two adjoin

  void add(char* begin, std::size_t bytes);
  void shrink_to(std::size_t bytes) noexcept;

  UnmapPages unmap_pages_;
  std::mutex mutex_;
  Waiting waiting_;
  std::size_t waiting_bytes_ = 0;
  std::size_t used_bytes_ = 0;
  std::size_t most_used_bytes_ = 0;  ///< since the first begin
  int begun_ = 0;
};

}  // namespace vcg_core::detail
