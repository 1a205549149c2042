// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/detail/array.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace vcg_core::detail {

namespace {

/// Two large pages of 2 MiB: a block of that size holds a whole one, wherever it begins.
constexpr std::size_t large = std::size_t(4) << 20;
constexpr std::align_val_t page{4096};

}  // namespace

void* allocate_array(std::size_t bytes) {
  if (bytes < large) return ::operator new(bytes);
  void* const block = ::operator new(bytes, page);
#ifdef MADV_HUGEPAGE
  ::madvise(block, bytes, MADV_HUGEPAGE);  // a wish: where it is not granted, nothing is lost
#endif
  return block;
}

void free_array(void* block, std::size_t bytes) noexcept {
  if (bytes < large) return ::operator delete(block);
  ::operator delete(block, page);
}

}  // namespace vcg_core::detail
