// SPDX-License-Identifier: GPL-3.0-or-later
// glTF 2.0, GLB and JSON: the triangles of all meshes, where their nodes put them in the world.

#include <cmath>

#include <mesh_tools/mesh.h>  // first: the header of vcglib below needs it

#include <vcg/complex/algorithms/update/bounding.h>

#include "../formats.h"
#include "gltf_file.h"
#include "gltf_vertices.h"

namespace mesh_tools::io {

MeshFile read_gltf(const std::string& bytes, const std::filesystem::path& path) {
  const GltfFile source = open_gltf(bytes, path);
  const GltfMesh found = find_gltf_mesh(source, path);
  if (found.corners.empty()) fail(path, "holds no triangles");
  MeshFile file;
  Mesh& mesh = file.mesh;
  bool all_in_world = true, all_normal = true;
  for (const GltfVertices& set : found.vertices) {
    all_in_world &= set.is_in_world;
    all_normal &= set.normals.has_value();
    auto vertex = vcg::tri::Allocator<Mesh>::AddVertices(mesh, set.positions.count);
    for (std::size_t i = 0; i < set.positions.count; ++i, ++vertex) {
      vertex->P() = place_of(source, set, i);
      if (set.normals) vertex->N() = normal_of(source, set, i);
    }
  }
  // A transform leaves more digits than floats have.
  file.precision = all_in_world ? Precision::single_precision : Precision::double_precision;
  if (all_normal) file.attributes |= vertex_normal;
  mesh.face.resize(found.corners.size() / 3);
  mesh.fn = static_cast<int>(mesh.face.size());
  for (std::size_t i = 0; i < found.corners.size(); ++i)
    mesh.face[i / 3].V(static_cast<int>(i % 3)) = &mesh.vert[found.corners[i]];
  for (const std::string& warning : found.warnings) file.warnings.push_back(path.string() + ": " + warning);
  file.not_kept.push_back(path.string() + ": of glTF only triangles and normals are kept in another format");
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
  return file;
}

}  // namespace mesh_tools::io
