// SPDX-License-Identifier: GPL-3.0-or-later
#include "fingerprint.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace tiles {

void Checksum::add(const void* bytes, std::size_t count) {
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15;
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    std::uint64_t word = 0;
    const std::size_t taken = std::min(count, sizeof word);
    std::memcpy(&word, at, taken);
    state_ = (state_ ^ word) * factor;
    state_ ^= state_ >> 29;
    at += taken;
    count -= taken;
  }
}

std::uint64_t sample_checksum(const InputFile& file, std::uint64_t header_size) {
  constexpr std::uint64_t samples = 64, sample_size = 4096;
  Checksum sum;
  std::vector<char> bytes(static_cast<std::size_t>(header_size));
  file.read(0, bytes.data(), bytes.size());
  sum.add(bytes.data(), bytes.size());
  for (std::uint64_t i = 0; i < samples; ++i) {
    const std::uint64_t at = std::max(header_size, file.size() / samples * i);
    bytes.resize(static_cast<std::size_t>(std::min(sample_size, file.size() - std::min(at, file.size()))));
    file.read(at, bytes.data(), bytes.size());
    sum.add(bytes.data(), bytes.size());
  }
  return sum.value();
}

}  // namespace tiles
