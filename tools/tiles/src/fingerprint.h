// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "input_file.h"

namespace tiles {

/// A checksum of 64 bits over bytes that come one after the other: finds damage, no forgery.
class Checksum {
 public:
  void add(const void* bytes, std::size_t count);
  void add(std::string_view text) { add(text.data(), text.size()); }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

/// What tells whether a file is still the same, without reading it all: checksum of its header and of samples.
std::uint64_t sample_checksum(const InputFile& file, std::uint64_t header_size);

}  // namespace tiles
