// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#if !defined(__GNUC__) && !defined(__clang__)
#include <intrin.h>
#endif

namespace vcg_core::detail {
namespace {  // its own in every kernel

/// The place of the lowest bit that is set, of those of which one is.
#if defined(__GNUC__) || defined(__clang__)
std::uint32_t lowest_bit(std::uint32_t bits) { return static_cast<std::uint32_t>(__builtin_ctz(bits)); }
std::uint32_t lowest_bit(std::uint64_t bits) { return static_cast<std::uint32_t>(__builtin_ctzll(bits)); }
#else
std::uint32_t lowest_bit(std::uint32_t bits) {
  unsigned long place;
  _BitScanForward(&place, bits);
  return place;
}
std::uint32_t lowest_bit(std::uint64_t bits) {
  unsigned long place;
  _BitScanForward64(&place, bits);
  return place;
}
#endif

}  // namespace
}  // namespace vcg_core::detail
