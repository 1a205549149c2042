// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_view.h"

#include <cstddef>

#include <vcg_core/mesh/vcglib_view.h>

namespace anisosmooth {

FileView::FileView(mesh_tools::MeshFile& file) : mesh_(file.mesh), view_(vcg_core::view_of(file.mesh)) {
  for (const auto& edge : mesh_.edge)
    for (int k = 0; k < 2; ++k) creases_.push_back(vcg::tri::Index(mesh_, edge.cV(k)));
  view_.creases = vcg_core::index_rows(creases_.data(), 2 * sizeof(std::uint64_t));
  view_.crease_count = creases_.size() / 2;
  if (file.precision == mesh_tools::Precision::double_precision) return;
  positions_.reserve(3 * mesh_.vert.size());
  qualities_.reserve(mesh_.vert.size());
  for (const auto& vertex : mesh_.vert) {
    for (int k = 0; k < 3; ++k) positions_.push_back(static_cast<float>(vertex.cP()[k]));
    qualities_.push_back(static_cast<float>(vertex.cQ()));
  }
  view_.positions = vcg_core::real_rows(positions_.data(), 3 * sizeof(float));
  view_.scalars = vcg_core::real_rows(qualities_.data(), sizeof(float));
}

void FileView::take_back() {
  for (std::size_t v = 0; v < qualities_.size(); ++v) {
    auto& vertex = mesh_.vert[v];
    for (std::size_t k = 0; k < 3; ++k) vertex.P()[static_cast<int>(k)] = positions_[3 * v + k];
    if (qualities_[v] != static_cast<float>(vertex.cQ())) vertex.Q() = qualities_[v];
  }
}

}  // namespace anisosmooth
