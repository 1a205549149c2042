// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0, GLB and JSON: the triangles of all meshes, where their nodes put them in the world.

#include <algorithm>

#include "../formats.h"
#include "gltf_file.h"
#include "gltf_vertices.h"

namespace mesh_tools::io {

FlatFile read_gltf(const std::string& bytes, const std::filesystem::path& path) {
  const GltfFile source = open_gltf(bytes, path);
  const GltfMesh found = find_gltf_mesh(source, path);
  if (found.corners.empty()) fail(path, "holds no triangles");
  const auto all = [&](auto holds) { return std::all_of(found.vertices.begin(), found.vertices.end(), holds); };
  const bool all_normal = all([](const GltfVertices& set) { return set.normals.has_value(); });
  FlatFile file;
  FlatMesh& mesh = file.mesh;
  // A transform leaves more digits than floats have.
  file.precision = all([](const GltfVertices& set) { return set.is_in_world; }) ? Precision::single_precision
                                                                                : Precision::double_precision;
  mesh.position = Points(file.precision);
  for (const GltfVertices& set : found.vertices)
    for (std::size_t i = 0; i < set.positions.count; ++i) {
      mesh.position.push_back(place_of(source, set, i));
      if (all_normal) mesh.vertex_normal.push_back(normal_of(source, set, i));
    }
  if (all_normal) file.attributes |= vertex_normal;
  mesh.face.resize(found.corners.size() / 3);
  for (std::size_t i = 0; i < found.corners.size(); ++i) mesh.face[i / 3][i % 3] = found.corners[i];
  for (const std::string& warning : found.warnings) file.warnings.push_back(path.string() + ": " + warning);
  file.not_kept.push_back(path.string() + ": of glTF only triangles and normals are kept in another format");
  return file;
}

}  // namespace mesh_tools::io
