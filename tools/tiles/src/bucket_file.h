// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "cut.h"
#include "input_file.h"
#include "large_mesh.h"

namespace tiles {

/// A face with its vertices and its own place, both as the file of the whole mesh counts them.
struct BucketFace {
  Face vertex;
  std::uint32_t index;
};

/// What some cells hold: all their vertices, and all faces with a vertex in one of them. A face may be there several
/// times.
struct BucketPart {
  std::vector<std::uint32_t> vertex;  ///< as the file counts them
  std::vector<char> position;         ///< three numbers each, in the file's precision
  std::vector<BucketFace> face;
};

/// The vertices of a tile and the faces that touch them, ordered by cell, so that a neighbour can read those near to it
/// alone.
class BucketFile {
 public:
  /// @param real_size  bytes of a coordinate
  /// @throws mesh_tools::FileError
  BucketFile(const std::filesystem::path& path, std::size_t real_size);

  std::size_t cells() const { return cell_.size(); }
  std::uint32_t cell(std::size_t i) const { return cell_[i].number; }
  std::uint32_t vertices_in(std::size_t i) const { return cell_[i].vertices; }
  /// Appends what the cells from place `begin` to `end` hold.
  void read(std::size_t begin, std::size_t end, BucketPart& part) const;

  /// Makes the file of a tile from its records in any order: vertices (index, three coordinates), and BucketFaces. Uses
  /// memory for all of them. These files are removed.
  static void make(const std::filesystem::path& path, const std::filesystem::path& vertices,
                   const std::filesystem::path& faces, std::size_t real_size, const Grid& grid);

 private:
  struct Cell {
    std::uint32_t number, vertices, faces;
  };

  InputFile file_;
  std::size_t real_size_;
  std::vector<Cell> cell_;
  std::vector<std::uint64_t> vertex_begin_, face_begin_;  // by place of the cell, and one more
  std::uint64_t data_begin_ = 0;
};

}  // namespace tiles
