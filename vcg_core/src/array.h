// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <new>
#include <vector>

namespace vcg_core::detail {

/// Memory for an array. For a large array the system is asked for large pages, where it has them: the first touch of
/// such memory takes a fraction of the time, and so does random access to it. Throws std::bad_alloc.
void* allocate_array(std::size_t bytes);
void free_array(void* block, std::size_t bytes) noexcept;

/// While one of these is there, large arrays that are freed leave their memory to the next ones, and the peak stays
/// what it is. For work that makes and frees many of them; at the end the system has all back.
class ArrayReuse {
 public:
  ArrayReuse() noexcept;
  ~ArrayReuse();
  ArrayReuse(const ArrayReuse&) = delete;
  ArrayReuse& operator=(const ArrayReuse&) = delete;
};

template <class T>
struct ArrayAllocator {
  using value_type = T;
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__, "blocks are not aligned for more");

  ArrayAllocator() = default;
  template <class U>
  ArrayAllocator(const ArrayAllocator<U>& /*other*/) noexcept {}

  T* allocate(std::size_t n) {
    if (n > (std::numeric_limits<std::size_t>::max)() / sizeof(T)) throw std::bad_alloc();
    return static_cast<T*>(allocate_array(n * sizeof(T)));
  }
  void deallocate(T* block, std::size_t n) noexcept { free_array(block, n * sizeof(T)); }

  friend bool operator==(const ArrayAllocator& /*a*/, const ArrayAllocator& /*b*/) { return true; }
  friend bool operator!=(const ArrayAllocator& /*a*/, const ArrayAllocator& /*b*/) { return false; }
};

/// What may grow with the mesh: mostly one element for each vertex, face or corner. Work memory of a thread, which is
/// used again and again, is as well off in a std::vector.
template <class T>
using Array = std::vector<T, ArrayAllocator<T>>;

/// Gives the memory of arrays back before others are made. Assigning {} keeps it.
template <class... T>
void release(Array<T>&... arrays) {
  (Array<T>().swap(arrays), ...);
}

}  // namespace vcg_core::detail
