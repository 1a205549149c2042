// SPDX-License-Identifier: GPL-3.0-or-later
#include "large_mesh.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "fail.h"
#include "io/formats.h"
#include "io/ply_roles.h"

namespace tiles {
namespace {

using mesh_tools::io::PlyLayout;
using mesh_tools::io::stl_facet_size;
using mesh_tools::io::stl_header_size;

constexpr std::size_t facet_normal_size = 3 * sizeof(float), corner_size = 3 * sizeof(float);

/// The header of a PLY file, and what follows within the first megabytes.
std::string head_of(const InputFile& file) {
  constexpr std::uint64_t longest_header = std::uint64_t(4) << 20;
  std::string head(static_cast<std::size_t>(std::min(file.size(), longest_header)), '\0');
  file.read(0, head.data(), head.size());
  return head;
}

/// They would have to follow the vertices.
void require_no_face_normals(const PlyLayout::Element& element, const std::filesystem::path& path) {
  if (element.name == "face" && mesh_tools::io::Roles(element, mesh_tools::io::known_of_face).has_normal())
    fail(path, "has normals of its faces, which would no longer fit; such files cannot be cut into pieces");
}

RowPlace facet_place() {
  RowPlace place;
  place.begin = stl_header_size;
  place.stride = stl_facet_size;
  place.swapped = mesh_tools::io::is_big_endian_machine();
  for (std::size_t k = 0; k < 3; ++k) place.offset[k] = facet_normal_size + k * sizeof(float);
  return place;
}

}  // namespace

LargeMesh::LargeMesh(const std::filesystem::path& path) : file_(std::make_unique<InputFile>(path)) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (extension != ".ply" && extension != ".stl")
    fail(path, "cannot be cut into pieces; binary .ply and .stl files can");
  if (extension == ".ply")
    open_ply();
  else
    open_stl();
  if (vertices_ == 0) fail(path, "holds no vertices");
  if (faces_ == 0) fail(path, "holds no faces; the filters need a triangle mesh");
}

void LargeMesh::open_ply() {
  const std::string head = head_of(*file_);
  const PlyLayout layout = mesh_tools::io::parse_ply_header(head, file_->path());
  if (layout.format == PlyLayout::Format::ascii)
    fail(file_->path(), "is text; only binary files can be cut into pieces, so convert it first");
  header_size_ = layout.data_offset;
  for (const PlyLayout::Element& element : layout.elements) elements_.emplace_back(layout, element);
  std::uint64_t begin = header_size_;
  bool has_vertices = false;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const PlyRows& rows = elements_[e];
    require_no_face_normals(rows.element, file_->path());
    if (rows.element.name == "vertex") {
      has_vertices = true;
      vertex_ = vertex_place(rows, {"x", "y", "z"}, begin, file_->path());
      vertices_ = rows.element.count;
      if (mesh_tools::io::Roles(rows.element, mesh_tools::io::known_of_vertex).has_normal()) {
        normal_ = vertex_place(rows, {"nx", "ny", "nz"}, begin, file_->path());
        normal_size_ = normal_.in_double[0] || normal_.in_double[1] || normal_.in_double[2] ? 8 : 4;
      }
      in_floats_ = !(vertex_.in_double[0] || vertex_.in_double[1] || vertex_.in_double[2]);
    }
    if (rows.element.name == "face") {
      face_element_ = e;
      faces_ = rows.element.count;
      faces_begin_ = begin;
      if (faces_ > 0 && rows.corners == rows.element.properties.size())
        fail(file_->path(), "declares faces without 'vertex_indices', a list of whole numbers");
    }
    if (rows.of_one_size) {
      begin += rows.element.count * rows.stride;
    } else if (!has_vertices || (faces_ == 0 && e + 1 < elements_.size())) {  // what is looked for lies behind it
      SequentialReader reader(*file_, begin, file_->size());
      for (std::size_t i = 0; i < rows.element.count; ++i) rows.read_number(reader, "");
      begin = reader.at();
    }
  }
  if (vertices_ > 0 && vertex_.begin + vertices_ * vertex_.stride > file_->size())
    fail(file_->path(), "is cut off: it ends within its vertices");
}

void LargeMesh::open_stl() {
  is_stl_ = true;
  char raw[4] = {};
  if (file_->size() >= stl_header_size) file_->read(stl_header_size - sizeof raw, raw, sizeof raw);
  if (mesh_tools::io::is_big_endian_machine()) std::reverse(raw, raw + sizeof raw);
  std::uint32_t count = 0;
  std::memcpy(&count, raw, sizeof count);
  if (file_->size() != stl_header_size + std::uint64_t{count} * stl_facet_size)
    fail(file_->path(), "is no binary STL file, whose size is 84 + 50 bytes a facet; only such can be cut into pieces");
  if (count > std::numeric_limits<std::int32_t>::max() / 3)
    fail(file_->path(), "has " + std::to_string(count) + " facets; at most 715827882 can be cut into pieces");
  header_size_ = stl_header_size;
  faces_ = count;
  vertices_ = std::size_t{3} * count;
  vertex_ = facet_place();
}

std::uint64_t LargeMesh::faces_begin() const { return is_stl_ ? header_size_ : faces_begin_; }

bool LargeMesh::has_selection() const {
  constexpr std::int64_t selected = 0x20;  // as vcglib has it
  for (const PlyRows& rows : elements_) {
    const bool is_vertex = rows.element.name == "vertex";
    if ((!is_vertex && rows.element.name != "face") || rows.element.find("flags") == nullptr) continue;
    SequentialReader reader(*file_, is_vertex ? vertex_.begin : faces_begin_, file_->size());
    for (std::size_t i = 0; i < rows.element.count; ++i)
      if (rows.read_number(reader, "flags") & selected) return true;
  }
  return false;
}

Point LargeMesh::position(std::size_t vertex) const {
  return is_stl_ ? read_point(vertex_, vertex / 3, vertex % 3 * corner_size) : read_point(vertex_, vertex, 0);
}

Point LargeMesh::normal(std::size_t vertex) const { return read_point(normal_, vertex, 0); }

/// @param shift  of the three numbers in their row
Point LargeMesh::read_point(const RowPlace& rows, std::size_t index, std::size_t shift) const {
  Point p;
  std::vector<char> row(rows.stride);
  file_->read(rows.begin + index * rows.stride, row.data(), row.size());
  for (std::size_t k = 0; k < 3; ++k) p[k] = rows.coordinate(row.data() + shift, k);
  return p;
}

VertexStream::VertexStream(const LargeMesh& mesh)
    : mesh_(mesh), reader_(mesh.file(), mesh.vertex_.begin, mesh.file().size()) {}

std::size_t VertexStream::read(std::vector<Point>& position) {
  const std::size_t count = std::min(position.size() - position.size() % 3, mesh_.vertices() - next_);
  const RowPlace& rows = mesh_.vertex_;
  if (mesh_.is_stl()) {
    for (std::size_t i = 0; i < count; i += 3) {
      const char* const facet = reader_.take(rows.stride);
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t k = 0; k < 3; ++k) position[i + corner][k] = rows.coordinate(facet + corner * corner_size, k);
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      const char* const row = reader_.take(rows.stride);
      for (std::size_t k = 0; k < 3; ++k) position[i][k] = rows.coordinate(row, k);
    }
  }
  next_ += count;
  return count;
}

FaceStream::FaceStream(const LargeMesh& mesh)
    : mesh_(mesh), reader_(mesh.file(), mesh.faces_begin(), mesh.file().size()) {}

std::size_t FaceStream::read(std::vector<Face>& face) {
  const std::size_t count = std::min(face.size(), mesh_.faces() - next_);
  for (std::size_t i = 0; i < count; ++i, ++next_) {
    const auto first = static_cast<std::uint32_t>(3 * next_);
    face[i] = mesh_.is_stl() ? Face{first, first + 1, first + 2}
                             : mesh_.elements_[mesh_.face_element_].read_triangle(reader_, next_, mesh_.vertices(),
                                                                                  mesh_.file().path());
  }
  return count;
}

}  // namespace tiles
