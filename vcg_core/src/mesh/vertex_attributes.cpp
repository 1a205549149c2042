// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_attributes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesh/rows.h"

namespace vcg_core::detail {

namespace {

template <class Real>
void store_if_finite(char* row, double value) {
  const auto stored = static_cast<Real>(value);
  if (std::isfinite(stored)) std::memcpy(row, &stored, sizeof stored);
}

}  // namespace

VertexAttributes read_attributes(const MeshView& view, const MeshArrays& mesh) {
  VertexAttributes attributes;
  attributes.has_color = static_cast<bool>(view.colors);
  attributes.has_scalar = static_cast<bool>(view.scalars);
  attributes.value.reserve(mesh.host_vertex.size() * attributes.channels());
  if (attributes.channels() == 0) return attributes;
  for (const Index host : mesh.host_vertex) {
    if (attributes.has_color)
      for (int k = 0; k < 4; ++k)
        attributes.value.push_back(load<std::uint8_t>(row_of(view.colors.data, view.colors.stride, host), k));
    if (attributes.has_scalar) attributes.value.push_back(load_real(view.scalars, host));
  }
  return attributes;
}

void commit_attributes(const MeshArrays& mesh, const VertexAttributes& attributes, const MeshView& view) {
  std::size_t next = 0;
  if (attributes.channels() == 0) return;
  for (const Index host : mesh.host_vertex) {
    if (attributes.has_color) {
      char* const row = row_of(view.colors.data, view.colors.stride, host);
      for (int k = 0; k < 4; ++k)
        row[k] = static_cast<char>(std::lround(std::clamp(attributes.value[next++], 0.0, 255.0)));
    }
    if (attributes.has_scalar) {
      char* const row = row_of(view.scalars.data, view.scalars.stride, host);
      const double value = attributes.value[next++];
      if (view.scalars.type == RealType::float32)
        store_if_finite<float>(row, value);
      else
        store_if_finite<double>(row, value);
    }
  }
}

}  // namespace vcg_core::detail
