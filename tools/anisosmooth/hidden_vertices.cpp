// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_vertices.h"

#include <cmath>

namespace anisosmooth {

HiddenVertices::HiddenVertices(mesh_tools::Mesh& mesh) : mesh_(mesh) {
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    const vcg::Point3d& place = mesh.vert[v].cP();
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2])) hidden_.push_back(v);
  }
  if (hidden_.empty()) return;
  for (const std::size_t v : hidden_) mesh.vert[v].SetD();
  for (auto& face : mesh.face)
    for (int k = 0; k < 3; ++k) face.V(k)->ClearD();
  for (auto& edge : mesh.edge)
    for (int k = 0; k < 2; ++k) edge.V(k)->ClearD();
  std::vector<std::size_t> unused;
  for (const std::size_t v : hidden_)
    if (mesh.vert[v].IsD()) unused.push_back(v);
  hidden_.swap(unused);
  mesh.vn -= static_cast<int>(hidden_.size());
}

HiddenVertices::~HiddenVertices() {
  for (const std::size_t v : hidden_) mesh_.vert[v].ClearD();
  mesh_.vn += static_cast<int>(hidden_.size());
}

}  // namespace anisosmooth
