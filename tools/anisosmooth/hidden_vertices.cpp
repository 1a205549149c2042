// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_vertices.h"

#include <algorithm>
#include <cmath>

namespace anisosmooth {

HiddenVertices::HiddenVertices(const mesh_tools::FlatMesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const vcg::Point3d place = mesh.position[v];
    if (std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2])) continue;
    marks.resize(mesh.vertices());
    marks[v] = 1;
  }
  if (marks.empty()) return;
  for (const auto& face : mesh.face)
    for (const std::uint32_t v : face) marks[v] = 0;
  for (const auto& edge : mesh.edge)
    for (const std::uint32_t v : edge) marks[v] = 0;
  count = static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
  if (count == 0) marks.clear();
}

}  // namespace anisosmooth
