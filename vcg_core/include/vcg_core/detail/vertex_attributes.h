#pragma once

#include <algorithm>
#include <cmath>

#include <vcg/complex/complex.h>

#include <vcg_core/detail/mesh_arrays.h>

namespace vcg_core::detail {

/// Per-vertex colour and quality, one number after the other for each vertex of MeshArrays. Colours in [0, 255].
struct VertexAttributes {
  bool has_color = false;
  bool has_quality = false;
  Array<double> value;

  std::size_t channels() const { return (has_color ? 4u : 0u) + (has_quality ? 1u : 0u); }
};

template <class Mesh>
VertexAttributes read_attributes(const Mesh& mesh, const MeshArrays& arrays) {
  VertexAttributes attributes;
  attributes.has_color = vcg::tri::HasPerVertexColor(mesh);
  attributes.has_quality = vcg::tri::HasPerVertexQuality(mesh);
  attributes.value.reserve(arrays.size() * attributes.channels());
  if (attributes.channels() == 0) return attributes;
  for (const Index host : arrays.host_vertex) {
    if (attributes.has_color)
      for (int k = 0; k < 4; ++k) attributes.value.push_back(mesh.vert[host].cC()[k]);
    if (attributes.has_quality) attributes.value.push_back(mesh.vert[host].cQ());
  }
  return attributes;
}

/// Writes them back; cannot fail. A quality that the mesh's own type could not hold stays as it was.
template <class Mesh>
void commit_attributes(const MeshArrays& arrays, const VertexAttributes& attributes, Mesh& mesh) {
  std::size_t next = 0;
  if (attributes.channels() == 0) return;
  for (const Index host : arrays.host_vertex) {
    auto& vertex = mesh.vert[host];
    if (attributes.has_color)
      for (int k = 0; k < 4; ++k)
        vertex.C()[k] = static_cast<unsigned char>(std::lround(std::clamp(attributes.value[next++], 0.0, 255.0)));
    if (attributes.has_quality) {
      const auto quality = static_cast<typename Mesh::VertexType::QualityType>(attributes.value[next++]);
      if (std::isfinite(quality)) vertex.Q() = quality;
    }
  }
}

}  // namespace vcg_core::detail
