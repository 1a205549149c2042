// SPDX-License-Identifier: GPL-3.0-or-later
#include "array.h"

#include <cstdint>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>

#include "freed_blocks.h"
#endif

// A sanitizer sees what is allocated by operator new only.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VCG_CORE_MAPS_MEMORY
#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#undef VCG_CORE_MAPS_MEMORY
#endif
#endif
#endif

namespace vcg_core::detail {

#ifdef VCG_CORE_MAPS_MEMORY

namespace {

constexpr std::size_t large_page = std::size_t(2) << 20;
/// Blocks begin where a large page may: one of this size is one.
constexpr std::size_t large = large_page;
/// A multiple of every system's page.
constexpr std::size_t page = std::size_t(64) << 10;

std::size_t in_pages(std::size_t bytes) { return (bytes + page - 1) / page * page; }

/// Null if there are none.
void* map_pages(std::size_t size) noexcept {
  void* const whole = ::mmap(nullptr, size + large_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (whole == MAP_FAILED) return nullptr;
  char* const begin = static_cast<char*>(whole);
  const std::size_t before = (large_page - reinterpret_cast<std::uintptr_t>(begin) % large_page) % large_page;
  if (before > 0) ::munmap(begin, before);
  if (before < large_page) ::munmap(begin + before + size, large_page - before);
#ifdef MADV_HUGEPAGE
  ::madvise(begin + before, size, MADV_HUGEPAGE);  // a wish: where it is not granted, nothing is lost
#endif
  return begin + before;
}

/// Never destroyed, as arrays may be freed late.
FreedBlocks& freed_blocks() {
  static FreedBlocks& blocks = *new FreedBlocks([](void* block, std::size_t bytes) { ::munmap(block, bytes); });
  return blocks;
}

}  // namespace

// From the system, not from a heap: that keeps what is freed between two blocks, a third of all memory where arrays of
// some dozen megabytes come and go.
void* allocate_array(std::size_t bytes) {
  if (bytes < large) return ::operator new(bytes);
  if (bytes > (std::numeric_limits<std::size_t>::max)() / 2) throw std::bad_alloc();
  const std::size_t size = in_pages(bytes);
  if (void* const block = freed_blocks().take(size)) return block;
  void* block = map_pages(size);
  if (block == nullptr && freed_blocks().release()) block = map_pages(size);
  if (block == nullptr) {
    freed_blocks().give_up(size);
    throw std::bad_alloc();
  }
  return block;
}

void free_array(void* block, std::size_t bytes) noexcept {
  if (bytes < large) return ::operator delete(block);
  freed_blocks().give(block, in_pages(bytes));
}

ArrayReuse::ArrayReuse() noexcept { freed_blocks().begin(); }
ArrayReuse::~ArrayReuse() { freed_blocks().end(); }

#else

void* allocate_array(std::size_t bytes) { return ::operator new(bytes); }
void free_array(void* block, std::size_t /*bytes*/) noexcept { ::operator delete(block); }
ArrayReuse::ArrayReuse() noexcept = default;
ArrayReuse::~ArrayReuse() = default;

#endif

}  // namespace vcg_core::detail
