// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <mesh_tools/mesh_io.h>

#include "../byte_source.h"

/// One function for each format that writes the bytes of a file as it was read, but for the coordinates of vertices
/// that have moved since, and the normals that follow. What did not change keeps its bytes, number by number.
namespace mesh_tools::io {

struct SpliceInput {
  const FlatFile& file;               ///< what was read from the bytes, with vertices moved
  const std::filesystem::path& path;  ///< where the bytes come from: for messages and material files
  bool recolored = false;             ///< whether colours and qualities of vertices may have changed too
};

/// Is given the result's bytes, one part after the other.
using Write = std::function<void(std::string_view)>;

/// What moved cannot be put into the file as it is; what() is a sentence without the file's name. A part of the result
/// may have been written.
class NoRoom : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All throw FileError where the bytes do not fit the mesh, and leave the bytes in any state.
/// @param out  where the result goes: names of textures, and of material files, are made relative to it
/// @throws NoRoom
void splice_ply(std::string& bytes, const SpliceInput& input, const std::filesystem::path& out, const Write& write);
void splice_obj(const std::string& bytes, const SpliceInput& input, const std::filesystem::path& out,
                const Write& write);
void splice_off(const std::string& bytes, const SpliceInput& input, const Write& write);
void splice_stl(ByteSource& bytes, const SpliceInput& input, const Write& write);
/// A mesh file, and others that appear together with it.
struct SplicedFiles {
  std::string mesh;
  std::vector<TextFile> beside;
};
/// @param out  where the result goes: buffers in files of their own that change go beside it, and names of others are
///             made relative to it
SplicedFiles splice_gltf(std::string bytes, const SpliceInput& input, const std::filesystem::path& out);

/// Throws FileError unless the file holds as many vertices, or facets, as were read from it.
void check_same_count(const std::filesystem::path& path, const char* what, std::size_t read, std::size_t found);

}  // namespace mesh_tools::io
