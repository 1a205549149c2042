// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "grid.h"
#include "input_file.h"
#include "ply_place.h"

namespace tiles {

/// A binary PLY or STL file of triangles that is never held in memory: only read, in the order of the file or vertex by
/// vertex. Of STL each facet has three vertices of its own, 3f to 3f + 2. All throw mesh_tools::FileError.
class LargeMesh {
 public:
  /// @throws mesh_tools::FileError: also for what cannot be cut into pieces: text, polygons, vertices with lists
  explicit LargeMesh(const std::filesystem::path& path);

  const InputFile& file() const { return *file_; }
  bool is_stl() const { return is_stl_; }
  std::size_t vertices() const { return vertices_; }
  std::size_t faces() const { return faces_; }
  bool in_floats() const { return in_floats_; }  ///< whether coordinates are in single precision
  std::size_t real_size() const { return in_floats_ ? 4 : 8; }
  std::uint64_t header_size() const { return header_size_; }

  /// Of PLY: where its vertices are, and what they hold. Of STL the facets.
  const RowPlace& vertex_rows() const { return vertex_; }
  /// Of PLY: where its faces begin; they are not all of one size.
  std::uint64_t faces_begin() const;

  Point position(std::size_t vertex) const;

  /// Bytes of a number of the vertices' normals; 0: they have none.
  std::size_t normal_size() const { return normal_size_; }
  const RowPlace& normal_rows() const { return normal_; }
  Point normal(std::size_t vertex) const;

  /// Whether a vertex or a face is marked as selected. Reads through those that can be.
  bool has_selection() const;

 private:
  friend class VertexStream;
  friend class FaceStream;
  void open_ply();
  void open_stl();

  std::unique_ptr<InputFile> file_;
  bool is_stl_ = false, in_floats_ = true;
  std::size_t vertices_ = 0, faces_ = 0;
  std::uint64_t header_size_ = 0;
  Point read_point(const RowPlace& rows, std::size_t index, std::size_t shift) const;

  RowPlace normal_;
  std::size_t normal_size_ = 0;
  RowPlace vertex_;                ///< of PLY's vertices, or of STL's facets
  std::vector<PlyRows> elements_;  ///< of PLY
  std::size_t face_element_ = 0;
  std::uint64_t faces_begin_ = 0;
};

/// The vertices in the order of the file.
class VertexStream {
 public:
  explicit VertexStream(const LargeMesh& mesh);
  /// Reads the next ones, as many as there are up to the size of `position`. None at the end.
  std::size_t read(std::vector<Point>& position);

 private:
  const LargeMesh& mesh_;
  SequentialReader reader_;
  std::size_t next_ = 0;
};

using Face = std::array<std::uint32_t, 3>;

/// The faces in the order of the file.
class FaceStream {
 public:
  explicit FaceStream(const LargeMesh& mesh);
  std::size_t read(std::vector<Face>& face);

 private:
  const LargeMesh& mesh_;
  SequentialReader reader_;
  std::size_t next_ = 0;
};

}  // namespace tiles
