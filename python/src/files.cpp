// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <json_figures/json_figures.h>
#include <mesh_tools/measure.h>
#include <mesh_tools/mesh_io.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <vcg/complex/allocate.h>
#include <vcg_core/errors.h>

#include "arrays.h"

namespace anisosmooth_python {

namespace nb = nanobind;
using namespace nb::literals;

namespace {

/// A mesh as it was read, with the bytes of its file, so that it can be written as it was with other positions.
struct ReadFile {
  mesh_tools::MeshFile file;
  mesh_tools::OriginalFile original;

  bool has(int attribute) const { return (file.attributes & attribute) != 0; }
};

/// One value of each vertex, or several, of a file's own precision.
template <class Number, class Get>
nb::object columns(const ReadFile& read, std::size_t width, const Get& get) {
  std::vector<Number> numbers;
  numbers.reserve(read.file.mesh.vert.size() * width);
  for (const auto& vertex : read.file.mesh.vert)
    for (std::size_t k = 0; k < width; ++k) numbers.push_back(static_cast<Number>(get(vertex, static_cast<int>(k))));
  return width == 1 ? to_array(std::move(numbers)) : to_array(std::move(numbers), width);
}

nb::object positions(const ReadFile& read) {
  const auto get = [](const auto& vertex, int k) { return vertex.cP()[k]; };
  return read.file.precision == mesh_tools::Precision::single_precision ? columns<float>(read, 3, get)
                                                                        : columns<double>(read, 3, get);
}

nb::object triangles(const ReadFile& read) {
  std::vector<std::int64_t> indices;
  indices.reserve(read.file.mesh.face.size() * 3);
  for (const auto& face : read.file.mesh.face)
    for (int k = 0; k < 3; ++k)
      indices.push_back(static_cast<std::int64_t>(vcg::tri::Index(read.file.mesh, face.cV(k))));
  return to_array(std::move(indices), 3);
}

nb::object colors(const ReadFile& read) {
  if (!read.has(mesh_tools::vertex_color_attribute)) return nb::none();
  return columns<std::uint8_t>(read, 4, [](const auto& vertex, int k) { return vertex.cC()[k]; });
}

nb::object scalars(const ReadFile& read) {
  if (!read.has(mesh_tools::vertex_quality_attribute)) return nb::none();
  return columns<double>(read, 1, [](const auto& vertex, int) { return vertex.cQ(); });
}

nb::object edges(const ReadFile& read) {
  if (read.file.mesh.edge.empty()) return nb::none();
  std::vector<std::int64_t> indices;
  indices.reserve(read.file.mesh.edge.size() * 2);
  for (const auto& edge : read.file.mesh.edge)
    for (int k = 0; k < 2; ++k)
      indices.push_back(static_cast<std::int64_t>(vcg::tri::Index(read.file.mesh, edge.cV(k))));
  return to_array(std::move(indices), 2);
}

nb::object selected(const ReadFile& read) {
  const auto& vertices = read.file.mesh.vert;
  std::vector<bool> marks(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) marks[v] = vertices[v].IsS();
  for (const auto& face : read.file.mesh.face)
    if (face.IsS())
      for (int k = 0; k < 3; ++k) marks[vcg::tri::Index(read.file.mesh, face.cV(k))] = true;
  if (std::find(marks.begin(), marks.end(), true) == marks.end()) return nb::none();
  return to_array(std::vector<std::uint8_t>(marks.begin(), marks.end())).attr("astype")("bool");
}

ReadFile read(const std::filesystem::path& path) {
  const nb::gil_scoped_release unlocked;
  ReadFile result;
  result.file = mesh_tools::read_mesh(path, &result.original);
  return result;
}

double number(const ReadOnlyArray& array, std::size_t row, std::size_t column) {
  const char* at = static_cast<const char*>(array.data()) + static_cast<std::ptrdiff_t>(row) * row_stride(array);
  if (array.dtype() == nb::dtype<float>()) return reinterpret_cast<const float*>(at)[column];
  return reinterpret_cast<const double*>(at)[column];
}

/// A mesh of the tools with these positions and faces, the latter of 64 bits.
/// @throws vcg_core::InvalidMesh  a face refers to no vertex
void fill(const ReadOnlyArray& positions, const ReadOnlyArray& faces, mesh_tools::Mesh& mesh) {
  using Allocator = vcg::tri::Allocator<mesh_tools::Mesh>;
  const std::size_t count = positions.shape(0);
  Allocator::AddVertices(mesh, count);
  for (std::size_t v = 0; v < count; ++v)
    for (int k = 0; k < 3; ++k) mesh.vert[v].P()[k] = number(positions, v, static_cast<std::size_t>(k));
  Allocator::AddFaces(mesh, faces.shape(0));
  for (std::size_t f = 0; f < faces.shape(0); ++f) {
    const auto* corners = reinterpret_cast<const std::int64_t*>(static_cast<const char*>(faces.data()) +
                                                                static_cast<std::ptrdiff_t>(f) * row_stride(faces));
    for (int k = 0; k < 3; ++k) {
      if (corners[k] < 0 || static_cast<std::size_t>(corners[k]) >= count)
        throw vcg_core::InvalidMesh("face " + std::to_string(f) + " refers to a vertex that the mesh does not have");
      mesh.face[f].V(k) = &mesh.vert[static_cast<std::size_t>(corners[k])];
    }
  }
}

void set_colors(const ReadOnlyArray& array, mesh_tools::MeshFile& file) {
  for (std::size_t v = 0; v < file.mesh.vert.size(); ++v) {
    const auto* row =
        static_cast<const std::uint8_t*>(array.data()) + static_cast<std::ptrdiff_t>(v) * row_stride(array);
    std::copy_n(row, 4, file.mesh.vert[v].C().V());
  }
  file.attributes |= mesh_tools::vertex_color_attribute;
}

void set_scalars(const ReadOnlyArray& array, mesh_tools::MeshFile& file) {
  for (std::size_t v = 0; v < file.mesh.vert.size(); ++v) file.mesh.vert[v].Q() = number(array, v, 0);
  file.attributes |= mesh_tools::vertex_quality_attribute;
}

/// Writes a mesh of arrays.
/// @return sentences about what the format cannot hold
std::vector<std::string> write(const std::filesystem::path& path, const ReadOnlyArray& vertices,
                               const ReadOnlyArray& faces, const std::optional<ReadOnlyArray>& color,
                               const std::optional<ReadOnlyArray>& scalar) {
  mesh_tools::MeshFile file;
  fill(vertices, faces, file.mesh);
  file.precision = vertices.dtype() == nb::dtype<float>() ? mesh_tools::Precision::single_precision
                                                          : mesh_tools::Precision::double_precision;
  if (color) set_colors(*color, file);
  if (scalar) set_scalars(*scalar, file);
  return mesh_tools::write_mesh(file, path);
}

/// Writes a mesh that was read, with these positions: see mesh_tools::write_moved().
std::vector<std::string> write_moved(const std::filesystem::path& path, const ReadFile& like,
                                     const ReadOnlyArray& vertices, const std::optional<ReadOnlyArray>& color,
                                     const std::optional<ReadOnlyArray>& scalar) {
  // Read again rather than copied: vcglib's meshes cannot be.
  mesh_tools::OriginalFile original;
  mesh_tools::MeshFile file = mesh_tools::read_mesh(like.original.path, &original);
  if (original.bytes != like.original.bytes)
    throw mesh_tools::FileError(like.original.path.string() + " has changed since it was read");
  for (std::size_t v = 0; v < file.mesh.vert.size(); ++v)
    for (int k = 0; k < 3; ++k) file.mesh.vert[v].P()[k] = number(vertices, v, static_cast<std::size_t>(k));
  if (color) set_colors(*color, file);
  if (scalar) set_scalars(*scalar, file);
  return mesh_tools::write_moved(file, std::move(original), path, color.has_value() || scalar.has_value());
}

std::string measure(const ReadOnlyArray& result, const ReadOnlyArray& faces, const ReadOnlyArray& reference,
                    const ReadOnlyArray& reference_faces, const std::optional<ReadOnlyArray>& noisy, int threads) {
  mesh_tools::Mesh result_mesh, reference_mesh, noisy_mesh;
  fill(result, faces, result_mesh);
  fill(reference, reference_faces, reference_mesh);
  if (noisy) fill(*noisy, faces, noisy_mesh);
  const nb::gil_scoped_release unlocked;
  return anisosmooth::to_json(mesh_tools::measure(result_mesh, reference_mesh, noisy ? &noisy_mesh : nullptr, threads))
      .dump();
}

}  // namespace

void declare_files(nb::module_& module) {
  nb::class_<ReadFile>(module, "ReadFile")
      .def_prop_ro("positions", &positions)
      .def_prop_ro("triangles", &triangles)
      .def_prop_ro("edges", &edges)
      .def_prop_ro("colors", &colors)
      .def_prop_ro("scalars", &scalars)
      .def_prop_ro("selected", &selected)
      .def_prop_ro("path", [](const ReadFile& read) { return read.original.path; })
      .def_prop_ro("warnings", [](const ReadFile& read) { return read.file.warnings; });
  module.def("read", &read, "path"_a);
  module.def("write", &write, "path"_a, "vertices"_a, "faces"_a, "colors"_a.none(), "scalars"_a.none());
  module.def("write_moved", &write_moved, "path"_a, "like"_a, "vertices"_a, "colors"_a.none(), "scalars"_a.none());
  module.def("measure", &measure, "result"_a, "faces"_a, "reference"_a, "reference_faces"_a, "noisy"_a.none(),
             "threads"_a);
}

}  // namespace anisosmooth_python
