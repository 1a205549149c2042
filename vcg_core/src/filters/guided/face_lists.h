// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh_arrays.h"
#include "sparse_index_map.h"

namespace vcg_core::detail {

/// A list of faces for each face, itself first. Block by block, in 16 bits an entry: lists are what the guided filter
/// would otherwise hold most of, and what it reads most often.
class FaceLists {
 public:
  /// Faces that follow each other.
  static constexpr std::size_t block_size = 256;
  /// So that 16 bits number all faces in the lists of a block, and 8 bits hold a length. On very uneven meshes a ball
  /// can hold any number of tiny faces.
  static constexpr std::size_t longest = 200;
  static_assert(block_size * longest <= std::size_t(1) << 16 && longest < std::size_t(1) << 8);

  struct Block {
    Index first = 0;              ///< of its faces
    std::size_t first_entry = 0;  ///< number of entries in the blocks before
    Array<std::uint8_t> length;   ///< of the list of each of its faces
    Array<std::uint16_t> entry;   ///< list after list: numbers of faces
    Array<Index> far;             ///< the faces in its lists that are not its own

    /// The face of a number: first those of the block, then those far.
    Index face(std::size_t number) const {
      return number < length.size() ? first + static_cast<Index>(number) : far[number - length.size()];
    }
    std::size_t numbers() const { return length.size() + far.size(); }
  };

  FaceLists() = default;
  explicit FaceLists(std::size_t faces);

  std::size_t blocks() const { return block_.size(); }
  const Block& block(std::size_t b) const { return block_[b]; }
  std::size_t entries() const { return entries_; }

  /// Writes the lists of one block after the other. Each thread has one of its own.
  class Writer {
   public:
    explicit Writer(FaceLists& lists) : lists_(lists), number_(lists.faces_) {}

    /// @param find  gives the list of a face, no longer than `longest`
    template <class Find>
    void write(std::size_t b, const Find& find) {
      begin(b);
      for (std::size_t i = 0; i < lists_.block_[b].length.size(); ++i)
        add(i, find(lists_.block_[b].first + static_cast<Index>(i)));
      end();
    }

   private:
    void begin(std::size_t b);
    void add(std::size_t i, const Array<Index>& list);
    void end();

    FaceLists& lists_;
    Block* block_ = nullptr;
    SparseIndexMap number_;  ///< of the faces far
    std::vector<std::uint16_t> entry_;
    std::vector<Index> far_;
  };

  /// To be called when all blocks are written.
  void number_entries();

 private:
  std::size_t faces_ = 0;
  std::size_t entries_ = 0;
  std::vector<Block> block_;
};

/// Calls visit(i, first, length) for each face of a block, the i-th: its list has the block's entries from `first` on.
template <class Visit>
void for_each_list(const FaceLists::Block& block, const Visit& visit) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < block.length.size(); first += block.length[i++]) visit(i, first, block.length[i]);
}

/// Puts the values of the faces in a block's lists side by side, so that the entries are their places.
/// @param value_of  gives that of a face
template <class Value, class ValueOf>
void gather(const FaceLists::Block& block, std::vector<Value>& values, const ValueOf& value_of) {
  values.resize(block.numbers());
  for (std::size_t i = 0; i < block.length.size(); ++i) values[i] = value_of(block.first + i);
  for (std::size_t i = 0; i < block.far.size(); ++i) values[block.length.size() + i] = value_of(block.far[i]);
}

}  // namespace vcg_core::detail
