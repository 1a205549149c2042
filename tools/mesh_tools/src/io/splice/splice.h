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

/// One function for each format that gives the bytes of a file as it was read, but for the coordinates of vertices that
/// have moved since, and the normals that follow. What did not change keeps its bytes, number by number.
namespace mesh_tools::io {

struct SpliceInput {
  const FlatFile& file;               ///< what was read from the bytes, with vertices moved
  const std::filesystem::path& path;  ///< where the bytes come from: for messages and material files
  bool recolored = false;             ///< whether colours and qualities of vertices may have changed too
};

/// What moved cannot be put into the file as it is; what() is a sentence without the file's name.
class NoRoom : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All throw FileError where the bytes do not fit the mesh.
/// @param out  where the result goes: names of textures, and of material files, are made relative to it
/// @throws NoRoom
std::string splice_ply(std::string bytes, const SpliceInput& input, const std::filesystem::path& out);
std::string splice_obj(std::string bytes, const SpliceInput& input, const std::filesystem::path& out);
/// A mesh file, and others that appear together with it.
struct SplicedFiles {
  std::string mesh;
  std::vector<TextFile> beside;
};
/// @param out  where the result goes: buffers in files of their own that change go beside it, and names of others are
/// made
///             relative to it
SplicedFiles splice_gltf(std::string bytes, const SpliceInput& input, const std::filesystem::path& out);
std::string splice_off(std::string bytes, const SpliceInput& input);
/// Part by part, as a binary file needs no more at a time.
/// @param write  is given the result's bytes, one part after the other
void splice_stl(ByteSource& bytes, const SpliceInput& input, const std::function<void(std::string_view)>& write);

/// Throws FileError unless the file holds as many vertices, or facets, as were read from it.
void check_same_count(const std::filesystem::path& path, const char* what, std::size_t read, std::size_t found);

}  // namespace mesh_tools::io
