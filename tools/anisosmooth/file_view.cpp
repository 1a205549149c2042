// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_view.h"

#include <cstddef>

namespace anisosmooth {

FileView::FileView(mesh_tools::FlatFile& file) : mesh_(file.mesh) {
  view_.vertices = mesh_.vertices();
  view_.faces = mesh_.face.size();
  if (!mesh_.face.empty()) view_.triangles = vcg_core::index_rows(mesh_.face[0].data(), sizeof mesh_.face[0]);
  if (!mesh_.edge.empty()) view_.creases = vcg_core::index_rows(mesh_.edge[0].data(), sizeof mesh_.edge[0]);
  view_.crease_count = mesh_.edge.size();
  const auto flags_of = [](const std::vector<std::int32_t>& flags) {
    if (flags.empty()) return vcg_core::FlagRows();
    return vcg_core::FlagRows{flags.data(), sizeof flags[0], mesh_tools::selected_flag, sizeof flags[0]};
  };
  view_.selected_vertices = flags_of(mesh_.vertex_flags);
  view_.selected_faces = flags_of(mesh_.face_flags);
  if (!mesh_.vertex_color.empty()) view_.colors = {mesh_.vertex_color[0].V(), sizeof mesh_.vertex_color[0]};
  const bool in_floats = file.precision == mesh_tools::Precision::single_precision;
  if (float* const floats = mesh_.position.floats()) {
    view_.positions = vcg_core::real_rows(floats, 3 * sizeof(float));
  } else if (!in_floats) {
    view_.positions = vcg_core::real_rows(mesh_.position.doubles(), 3 * sizeof(double));
  } else {
    for (std::size_t v = 0; v < mesh_.vertices(); ++v)
      for (int k = 0; k < 3; ++k) positions_.push_back(static_cast<float>(mesh_.position.number(v, k)));
    view_.positions = vcg_core::real_rows(positions_.data(), 3 * sizeof(float));
  }
  if (mesh_.vertex_quality.empty()) return;
  if (in_floats) {
    for (const double quality : mesh_.vertex_quality) qualities_.push_back(static_cast<float>(quality));
    view_.scalars = vcg_core::real_rows(qualities_.data(), sizeof(float));
  } else {
    view_.scalars = vcg_core::real_rows(mesh_.vertex_quality.data(), sizeof(double));
  }
}

void FileView::take_back() {
  for (std::size_t i = 0; i < positions_.size(); ++i)
    mesh_.position.set(i / 3, static_cast<int>(i % 3), static_cast<double>(positions_[i]));
  for (std::size_t v = 0; v < qualities_.size(); ++v)
    if (qualities_[v] != static_cast<float>(mesh_.vertex_quality[v])) mesh_.vertex_quality[v] = qualities_[v];
}

}  // namespace anisosmooth
