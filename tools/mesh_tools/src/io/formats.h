#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <mesh_tools/mesh_io.h>

/// One reader and one writer for each format; read_mesh and write_mesh choose and see to files, permissions, renaming.
namespace mesh_tools::io {

/// Readers take the file's bytes; its path is for messages and for what it refers to.
MeshFile read_ply(const std::string& bytes, const std::filesystem::path& path);
MeshFile read_obj(const std::string& bytes, const std::filesystem::path& path);
MeshFile read_off(const std::string& bytes, const std::filesystem::path& path);
MeshFile read_stl(const std::string& bytes, const std::filesystem::path& path);

/// Writers give the file's bytes.
std::string ply_bytes(const MeshFile& file);
std::string off_bytes(const MeshFile& file);
std::string stl_bytes(const MeshFile& file);

/// An OBJ file and its material file; the latter is empty if there are no materials.
struct ObjBytes {
  std::string mesh, materials;
};
/// @param material_name  of the material file, as the mesh names it
ObjBytes obj_bytes(const MeshFile& file, const std::string& material_name);

/// Binary STL: 80 bytes of header and a count, then facets of 50 bytes.
constexpr std::size_t stl_header_size = 84, stl_facet_size = 50;
bool is_binary_stl(const std::string& bytes);

/// Attributes that a format can hold, as bits of vcg::tri::io::Mask.
constexpr int vertex_normal = 0x10, vertex_color = 0x4, vertex_quality = 0x8, vertex_texture = 0x20, vertex_flags = 0x2,
              vertex_radius = 0x10000, face_flags = 0x80, face_color = 0x100, face_quality = 0x200, face_normal = 0x400,
              wedge_texture = 0x1000, wedge_texture_index = 0x2000, edges = 0x80000, camera = 0x8000;
constexpr int ply_attributes = vertex_normal | vertex_color | vertex_quality | vertex_texture | vertex_flags |
                               vertex_radius | face_flags | face_color | face_quality | face_normal | wedge_texture |
                               wedge_texture_index | edges;
constexpr int obj_attributes = vertex_normal | vertex_color | wedge_texture | wedge_texture_index | face_color | edges;
constexpr int off_attributes = vertex_normal | vertex_color | face_color;
constexpr int stl_attributes = face_color;

/// Adds what is not kept of polygons, if there are any: that they are cut into triangles.
void note_polygons(std::size_t count, const std::filesystem::path& path, MeshFile& file);

/// "FILE: what" as a FileError.
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what);
[[noreturn]] void fail_at_line(const std::filesystem::path& path, std::size_t line, const std::string& what);

/// A word of a file as part of a message: cut short, without control characters.
std::string printable(std::string_view word);

bool is_big_endian_machine();

/// The whole file as bytes.
std::string read_bytes(const std::filesystem::path& path);

}  // namespace mesh_tools::io
