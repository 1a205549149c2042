// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

/// Numbers in the bytes of binary files: little-endian, unless a format says otherwise.
namespace mesh_tools::io {

inline bool is_big_endian_machine() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

/// The number whose bytes stand at `at`.
/// @param swapped  whether they are in the other order than this machine's
template <class Number>
Number number_at(const char* at, bool swapped = is_big_endian_machine()) {
  char raw[sizeof(Number)];
  std::memcpy(raw, at, sizeof raw);
  if (swapped) std::reverse(raw, raw + sizeof raw);
  Number number;
  std::memcpy(&number, raw, sizeof raw);
  return number;
}

template <class Number>
void put_number(char* at, Number number, bool swapped = is_big_endian_machine()) {
  std::memcpy(at, &number, sizeof number);
  if (swapped) std::reverse(at, at + sizeof number);
}

template <class Number>
void append_binary(std::string& bytes, Number number) {
  char raw[sizeof number];
  put_number(raw, number);
  bytes.append(raw, sizeof raw);
}

}  // namespace mesh_tools::io
