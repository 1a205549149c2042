// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/allocation_failure.h>

#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
thread_local std::size_t left = no_limit;
thread_local bool has_failed = false;

void* take(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void count_down() {
  if (left == no_limit) return;
  if (left == 0) {
    has_failed = true;
    throw std::bad_alloc();
  }
  --left;
}

}  // namespace

void* operator new(std::size_t size) {
  count_down();
  return take(std::malloc(size > 0 ? size : 1));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  count_down();
  const auto step = static_cast<std::size_t>(alignment);
  return take(std::aligned_alloc(step, (size + step - 1) / step * step));
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }

namespace test_support {

void fail_allocations_after(std::size_t count) {
  left = count;
  has_failed = false;
}

bool allow_allocations() {
  left = no_limit;
  return has_failed;
}

}  // namespace test_support
