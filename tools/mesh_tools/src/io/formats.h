// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <mesh_tools/mesh_io.h>

#include "binary.h"

/// One reader and one writer for each format; read_mesh and write_mesh choose and see to files, permissions, renaming.
namespace mesh_tools::io {

class ByteSource;

/// Readers take the file's bytes; its path is for messages and for what it refers to.
FlatFile read_ply(const std::string& bytes, const std::filesystem::path& path);
FlatFile read_obj(const std::string& bytes, const std::filesystem::path& path);
FlatFile read_off(const std::string& bytes, const std::filesystem::path& path);
FlatFile read_stl(ByteSource& bytes, const std::filesystem::path& path);
FlatFile read_gltf(const std::string& bytes, const std::filesystem::path& path);

/// Writers give the file's bytes.
/// @param textures  in the place of the mesh's own: relative to the file
std::string ply_bytes(const FlatFile& file, const std::vector<std::string>& textures);
std::string off_bytes(const FlatFile& file);
std::string stl_bytes(const FlatFile& file);

/// An OBJ file and its material file; the latter is empty if there are no materials.
struct ObjBytes {
  std::string mesh, materials;
};
/// @param material_name  of the material file, as the mesh names it
ObjBytes obj_bytes(const FlatFile& file, const std::vector<std::string>& textures, const std::string& material_name);

/// Binary STL: 80 bytes of header and a count, then facets of 50 bytes.
constexpr std::size_t stl_header_size = 84, stl_facet_size = 50;
constexpr std::size_t stl_facet_offset(std::size_t facet) { return stl_header_size + facet * stl_facet_size; }
struct StlLayout {
  bool is_binary = false;    ///< as its size says
  bool may_be_text = false;  ///< if it is not binary
  std::size_t facets = 0;    ///< of a binary file, that are there
  std::size_t declared = 0;  ///< and that its header counts
};
/// How to read a file that may be STL. Bytes may follow the last facet of a binary file, and its count may be too small
/// if nothing else follows.
StlLayout stl_layout(ByteSource& bytes);

/// The first words of lines in text STL, in small letters or capitals.
enum class StlKeyword { none, comment, solid, facet, loop, vertex, end_of_facet };
StlKeyword stl_keyword(std::string_view word);

/// Attributes that a format can hold, as bits of vcg::tri::io::Mask.
constexpr int vertex_normal = 0x10, vertex_color = 0x4, vertex_quality = 0x8, vertex_texture = 0x20, vertex_flags = 0x2,
              vertex_radius = 0x10000, face_flags = 0x80, face_color = 0x100, face_quality = 0x200, face_normal = 0x400,
              wedge_texture = 0x1000, wedge_texture_index = 0x2000, edges = 0x80000, camera = 0x8000;
constexpr int ply_attributes = vertex_normal | vertex_color | vertex_quality | vertex_texture | vertex_flags |
                               vertex_radius | face_flags | face_color | face_quality | face_normal | wedge_texture |
                               wedge_texture_index | edges;
constexpr int obj_attributes =
    vertex_normal | vertex_color | vertex_texture | wedge_texture | wedge_texture_index | face_color | edges;
constexpr int off_attributes = vertex_normal | vertex_color | face_color;
constexpr int stl_attributes = face_color;

/// Warns of faces with fewer than three corners, if there are any: they are passed over.
void note_small_faces(std::size_t count, const std::filesystem::path& path, FlatFile& file);

/// Whether a face has texture coordinates, of a mesh that has some.
inline bool is_textured(const FlatMesh& mesh, std::size_t face) { return !std::isnan(mesh.wedge_texture[face][0].u); }

/// "FILE: what" as a FileError.
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what);
[[noreturn]] void fail_at_line(const std::filesystem::path& path, std::size_t line, const std::string& what);

/// A word of a file as part of a message: cut short, without control characters.
std::string printable(std::string_view word);

}  // namespace mesh_tools::io
