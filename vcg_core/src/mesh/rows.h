// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <vcg_core/mesh/mesh_view.h>

#include "mesh_arrays.h"

namespace vcg_core::detail {

// Reading and writing the caller's numbers, byte by byte: they may be of any type and need not be aligned.

inline const char* row_of(const void* data, std::ptrdiff_t stride, std::size_t row) {
  return static_cast<const char*>(data) + static_cast<std::ptrdiff_t>(row) * stride;
}

inline char* row_of(void* data, std::ptrdiff_t stride, std::size_t row) {
  return static_cast<char*>(data) + static_cast<std::ptrdiff_t>(row) * stride;
}

/// The k-th number that lies at `row`.
template <class Number>
Number load(const char* row, int k = 0) {
  Number number;
  std::memcpy(&number, row + static_cast<std::size_t>(k) * sizeof(Number), sizeof(Number));
  return number;
}

template <class Real>
Vec3 load_point(const char* row) {
  return Vec3(load<Real>(row, 0), load<Real>(row, 1), load<Real>(row, 2));
}

inline Vec3 load_point(const RealRows& rows, std::size_t i) {
  const char* const row = row_of(rows.data, rows.stride, i);
  return rows.type == RealType::float32 ? load_point<float>(row) : load_point<double>(row);
}

inline double load_real(const RealRows& rows, std::size_t i) {
  const char* const row = row_of(rows.data, rows.stride, i);
  return rows.type == RealType::float32 ? load<float>(row) : load<double>(row);
}

inline bool is_set(const FlagRows& flags, std::size_t i) {
  if (!flags) return false;
  const char* const row = row_of(flags.data, flags.stride, i);
  return ((flags.size == 1 ? load<std::uint8_t>(row) : load<std::uint32_t>(row)) & flags.mask) != 0;
}

/// The k-th index of a row; what is no vertex's index is larger than any.
inline std::size_t load_index(const IndexRows& rows, std::size_t i, int k) {
  const char* const row = row_of(rows.data, rows.stride, i);
  switch (rows.type) {
    case IndexType::int32:
      return static_cast<std::size_t>(load<std::int32_t>(row, k));
    case IndexType::uint32:
      return load<std::uint32_t>(row, k);
    case IndexType::int64:
      return static_cast<std::size_t>(load<std::int64_t>(row, k));
    case IndexType::uint64:
      return static_cast<std::size_t>(load<std::uint64_t>(row, k));
    case IndexType::address:
      break;
  }
  // As addresses: a pointer into another array has no difference to subtract. One before the first record gives a
  // difference beyond all counts.
  return static_cast<std::size_t>(load<std::uintptr_t>(row, k) - reinterpret_cast<std::uintptr_t>(rows.records)) /
         rows.record_size;
}

}  // namespace vcg_core::detail
