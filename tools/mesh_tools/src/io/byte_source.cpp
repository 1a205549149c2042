// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_source.h"

#include <algorithm>

namespace mesh_tools::io {

const char* BytesOfFile::part(std::size_t offset, std::size_t count) {
  constexpr std::size_t window = std::size_t(1) << 18;  // stays in the processor's caches
  if (offset < begin_ || offset + count > begin_ + bytes_.size()) {
    bytes_.resize(std::min(std::max(count, window), size() - offset));
    file_.read(offset, bytes_.data(), bytes_.size());
    begin_ = offset;
  }
  return bytes_.data() + (offset - begin_);
}

std::string& BytesOfFile::whole() {
  if (bytes_.size() < size()) bytes_ = file_.read();
  begin_ = 0;
  return bytes_;
}

}  // namespace mesh_tools::io
