// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <durable_files/input_file.h>
#include <mesh_tools/flat_mesh.h>
#include <mesh_tools/mesh.h>

namespace mesh_tools {

/// A file cannot be read or written; what() is one sentence that says which, what and what is allowed.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller asked to stop while a file was being written; nothing was left behind.
class WriteInterrupted : public std::runtime_error {
 public:
  WriteInterrupted() : std::runtime_error("interrupted") {}
};

/// The extension of a path in small letters, with its dot; empty if there is none.
std::string extension(const std::filesystem::path& path);

/// Bits of MeshFile::attributes that programs ask for or set; the values are vcg::tri::io::Mask's.
constexpr int normal_attributes = 0x10 | 0x400;  // of vertices, of faces
constexpr int vertex_quality_attribute = 0x8;
constexpr int vertex_color_attribute = 0x4;

/// The polygons of more than three corners that a file's triangles were cut from.
struct Polygons {
  struct Polygon {
    std::uint32_t first_face;    ///< a polygon of n corners is n - 2 triangles, one behind the other
    std::uint32_t first_corner;  ///< in `corners`; they end where those of the next polygon begin
  };
  std::vector<Polygon> polygons;       ///< in the order of their triangles
  std::vector<std::uint32_t> corners;  ///< around each polygon, as corners of its triangles: 3 * face + k
};

/// What belongs to a file besides its mesh.
struct FileFacts {
  Polygons polygons;
  std::optional<std::filesystem::path> folder;  ///< where the names of mesh.textures begin; none: where it is written
  Precision precision = Precision::double_precision;  ///< of the file; text formats declare none and count as double
  bool free_layout = false;                           ///< of an OFF file whose vertices and faces are not one a line
  double color_scale = 1;                             ///< what makes the file's colour components of vertices 0 to 255
  int attributes = 0;                 ///< bits of vcg::tri::io::Mask: what the file holds, and what is to be written
  std::vector<std::string> warnings;  ///< what is odd about the file, in sentences
  std::vector<std::string> not_kept;  ///< what of the file is not in here, so that write_mesh() loses it, in sentences
};

/// A file as flat arrays: what readers fill and writers take. Positions are in the precision of the file.
struct FlatFile : FileFacts {
  FlatMesh mesh;
};

/// A file as a mesh of vcglib's, for what works on such a mesh.
struct MeshFile : FileFacts {
  Mesh mesh;
};

FlatFile to_flat(const MeshFile& file);  ///< deleted elements left out; positions in double precision
MeshFile to_vcglib(FlatFile file);

/// A file as it was read.
struct OriginalFile {
  std::filesystem::path path;
  std::string bytes;
};

/// A file that was read and will be read again, when it is written with other numbers: meanwhile its bytes are not
/// kept.
class SourceFile {
 public:
  SourceFile() = default;
  /// @throws FileError
  explicit SourceFile(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return file_.path(); }
  std::size_t size() const { return file_.state().size; }  ///< when it was opened
  std::string read() const;                                ///< @throws FileError
  /// `count` bytes from `offset` on, which are there.
  /// @throws FileError
  void read(std::size_t offset, char* bytes, std::size_t count) const;
  bool has_changed() const;  ///< whether its size or its time is another one than when it was opened

 private:
  durable_files::InputFile file_;
};

/// A text and where it goes.
struct TextFile {
  std::filesystem::path path;
  std::string text;
};

/// Reads PLY, OBJ, OFF, STL, GLB or glTF, told by the extension, by readers of our own: of vcglib's importers of
/// MeshLab 2020.09 the one of PLY does not check the last corner of polygons, strips and grids, the one of OBJ drops
/// every face that refers to the first vertex, the one of OFF does not check indices, the one of STL runs past a
/// buffer. Polygons are cut into triangles, convex ones into fans. STL knows no shared vertices: those at exactly the
/// same place are merged.
/// @param original  gets the file itself, for write_moved()
/// @throws FileError
MeshFile read_mesh(const std::filesystem::path& path, OriginalFile* original = nullptr);
/// The same as flat arrays.
/// @param source  gets the file, for write_moved()
FlatFile read_flat(const std::filesystem::path& path, SourceFile* source = nullptr);

/// Writes PLY (binary), OBJ, OFF or STL (binary), told by the extension, by writers of our own: vcglib's OBJ and OFF
/// lose digits, its PLY is wrong for some attributes in double precision. The file appears complete or not at all: it
/// is written beside its place, flushed to the disk, and renamed (see durable_files). An OBJ file's materials go to a
/// file beside it. Text has the digits that give the same number back.
/// @param interrupted  asked just before the renaming; true: stop, leave nothing
/// @param with         a text file that appears together with the mesh, or neither of them
/// @return             sentences about what is lost: MeshFile::not_kept, and attributes that the format cannot hold
/// @throws FileError, WriteInterrupted
std::vector<std::string> write_mesh(const MeshFile& file, const std::filesystem::path& path,
                                    const std::function<bool()>& interrupted = {}, const TextFile* with = nullptr);
std::vector<std::string> write_mesh(const FlatFile& file, const std::filesystem::path& path,
                                    const std::function<bool()>& interrupted = {}, const TextFile* with = nullptr);

/// Writes a mesh that was read and whose vertices have moved since. In the format that was read this is a copy of the
/// original with other numbers: only coordinates that are no longer the same are replaced, and the normals of vertices
/// and faces that they belong to; with nothing moved, it is the original byte for byte. Text and binary, order, types,
/// polygons, groups, materials, comments, unknown properties stay. Normals keep their structure (see
/// docs/command-line.md). In another folder, the path of an OBJ file's materials becomes relative to that folder. In
/// another format: as write_mesh(), with normals recomputed if there are any.
/// @param original   of read_mesh()
/// @param recolored  colours and qualities of vertices may have changed too
/// @throws FileError, WriteInterrupted
std::vector<std::string> write_moved(MeshFile& file, OriginalFile original, const std::filesystem::path& path,
                                     bool recolored, const std::function<bool()>& interrupted = {},
                                     const TextFile* with = nullptr);
/// The same, and where the source has changed meanwhile: as in another format, with a sentence that says so; of glTF an
/// error.
std::vector<std::string> write_moved(FlatFile& file, const SourceFile& source, const std::filesystem::path& path,
                                     bool recolored, const std::function<bool()>& interrupted = {},
                                     const TextFile* with = nullptr);

/// Whether a file is read or written by its extension, and a sentence that names those which are.
bool has_known_extension(const std::filesystem::path& path);
std::string known_extensions();

/// The files that are written for a mesh at `path`: itself and, of an OBJ file, its materials, of a glTF file, its
/// buffer.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& path);

/// Throws FileError unless a mesh can be written to `path`: known extension, existing folder, nothing but a regular
/// file in its place. Cheap: to be asked before long work.
/// @param from  what was or will be read: GLB and glTF are only written as copies of such files
void check_writable(const std::filesystem::path& path, const std::filesystem::path& from = {});

/// The same for a text file, whatever its extension.
void check_text_writable(const std::filesystem::path& path);

/// Writes a text file in the same way: complete or not at all.
/// @throws FileError, WriteInterrupted
void write_text(const TextFile& file, const std::function<bool()>& interrupted = {});

/// Recomputes vertex and face normals from positions.
void update_normals(Mesh& mesh);
void update_normals(FlatMesh& mesh);

}  // namespace mesh_tools
