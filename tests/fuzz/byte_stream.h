// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace fuzz {

/// Takes values from a fuzzer's input, byte by byte as they lie in memory; zeros when it has run out.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  template <class Value>
  Value take() {
    Value value{};
    const std::size_t size = std::min(left_, sizeof value);
    std::memcpy(static_cast<void*>(&value), data_, size);
    data_ += size;
    left_ -= size;
    return value;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

/// The opposite, for seeds.
class ByteWriter {
 public:
  template <class Value>
  void put(Value value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof value);
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace fuzz
