// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <vcg/math/matrix44.h>
#include <nlohmann/json.hpp>

namespace mesh_tools::io {

/// A glTF 2.0 file, GLB or JSON, taken apart: its JSON, and the bytes of its buffers.
struct GltfFile {
  bool is_glb = false;
  std::string_view text;  ///< the JSON, a part of the file
  std::shared_ptr<const nlohmann::json> json;
  struct Buffer {
    enum class Place { nowhere, chunk, data_uri, file } place = Place::nowhere;
    std::string bytes;
    std::size_t chunk_at = 0;    ///< of Place::chunk: where it begins in the file
    std::filesystem::path name;  ///< of Place::file: from the folder of the glTF file
    std::string data_prefix;     ///< of Place::data_uri: what is before the base64
    std::string problem;         ///< of Place::nowhere: why
  };
  std::vector<Buffer> buffers;
};

/// @param bytes  referred to
/// @throws FileError
GltfFile open_gltf(const std::string& bytes, const std::filesystem::path& path);

/// A name with what "%20" and the like stand for.
std::string without_escapes(std::string_view uri);

/// Vectors of three floats in a buffer.
struct GltfVectors {
  std::size_t accessor, buffer, offset, stride, count;
};

/// The places of one accessor, each a vertex of the mesh, and where they are in the world.
struct GltfVertices {
  GltfVectors positions;
  std::optional<GltfVectors> normals;
  vcg::Matrix44d to_world, from_world;
  bool is_in_world = true;  ///< whether that is the identity
};

/// The triangles of all meshes.
struct GltfMesh {
  std::vector<GltfVertices> vertices;  ///< the vertices of the mesh are theirs, one after the other
  std::vector<std::uint32_t> corners;  ///< three for each triangle, as indices into all vertices
  std::vector<std::string> warnings;
};

/// @throws FileError: indices out of range, and by name what cannot be changed in place: compressed or quantised
///         positions, sparse ones, morph targets
GltfMesh find_gltf_mesh(const GltfFile& file, const std::filesystem::path& path);

}  // namespace mesh_tools::io
