// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_lists.h"

#include <algorithm>

namespace vcg_core::detail {

FaceLists::FaceLists(std::size_t faces) : faces_(faces), block_((faces + block_size - 1) / block_size) {
  for (std::size_t b = 0; b < block_.size(); ++b) {
    block_[b].first = static_cast<Index>(b * block_size);
    block_[b].length.resize(std::min(block_size, faces - b * block_size));
  }
}

void FaceLists::number_entries() {
  entries_ = 0;
  for (Block& block : block_) {
    block.first_entry = entries_;
    entries_ += block.entry.size();
  }
}

void FaceLists::Writer::begin(std::size_t b) {
  block_ = &lists_.block_[b];
  number_.clear();
  entry_.clear();
  far_.clear();
}

void FaceLists::Writer::add(std::size_t i, const Array<Index>& list) {
  const std::size_t own = block_->length.size();
  block_->length[i] = static_cast<std::uint8_t>(list.size());
  for (const Index f : list) {
    if (f - block_->first < own) {
      entry_.push_back(static_cast<std::uint16_t>(f - block_->first));
      continue;
    }
    std::uint32_t number = number_[f];
    if (number == SparseIndexMap::none) {
      number = static_cast<std::uint32_t>(own + far_.size());
      number_.set(f, number);
      far_.push_back(f);
    }
    entry_.push_back(static_cast<std::uint16_t>(number));
  }
}

void FaceLists::Writer::end() {
  block_->entry.assign(entry_.begin(), entry_.end());
  block_->far.assign(far_.begin(), far_.end());
}

}  // namespace vcg_core::detail
