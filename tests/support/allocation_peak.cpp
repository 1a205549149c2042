// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/allocation_peak.h>

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> taken{0};
std::atomic<std::size_t> most{0};

void* take(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  const std::size_t now = taken += malloc_usable_size(block);
  std::size_t last = most;
  while (now > last && !most.compare_exchange_weak(last, now)) {
  }
  return block;
}

void give_back(void* block) {
  taken -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return take(std::malloc(size > 0 ? size : 1)); }

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return take(std::aligned_alloc(step, (size + step - 1) / step * step));
}

void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }

namespace test_support {

AllocationPeak::AllocationPeak() : before_(taken) { most = before_; }

std::size_t AllocationPeak::bytes() const { return most - before_; }

}  // namespace test_support
