// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlated.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mesh_tools {

namespace {

/// Of the correlation length; beyond, the weights are below exp(-8).
constexpr double reach = 2;

/// Neighbours along edges: those of v are neighbour[begin[v]] to neighbour[begin[v + 1] - 1].
struct Adjacency {
  std::vector<std::size_t> begin, neighbour;
};

Adjacency adjacency_of(const Mesh& mesh, const std::vector<std::size_t>& first) {
  std::vector<std::pair<std::size_t, std::size_t>> sides;
  sides.reserve(6 * mesh.face.size());
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = first[vcg::tri::Index(mesh, face.cV(k))];
      const std::size_t b = first[vcg::tri::Index(mesh, face.cV((k + 1) % 3))];
      sides.emplace_back(a, b);
      sides.emplace_back(b, a);
    }
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  Adjacency adjacency;
  adjacency.begin.assign(first.size() + 1, 0);
  for (const auto& [a, b] : sides) {
    ++adjacency.begin[a + 1];
    adjacency.neighbour.push_back(b);
  }
  for (std::size_t v = 0; v < first.size(); ++v) adjacency.begin[v + 1] += adjacency.begin[v];
  return adjacency;
}

}  // namespace

std::vector<vcg::Point3d> correlated(const Mesh& mesh, double length, const std::vector<std::size_t>& first,
                                     const std::vector<vcg::Point3d>& values) {
  const Adjacency adjacency = adjacency_of(mesh, first);
  std::vector<vcg::Point3d> result(values.size(), vcg::Point3d(0, 0, 0));
  std::vector<std::size_t> reached_from(values.size(), values.size());  // the last vertex whose search came by
  std::vector<std::size_t> found;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (first[v] != v) continue;
    found.assign(1, v);
    reached_from[v] = v;
    vcg::Point3d sum(0, 0, 0);
    double squares = 0;
    for (std::size_t next = 0; next < found.size(); ++next) {
      const std::size_t u = found[next];
      // The convolution of two Gaussians exp(-2 d^2 / length^2) is the wanted correlation.
      const double distance = (mesh.vert[u].cP() - mesh.vert[v].cP()).Norm() / length;
      const double weight = std::exp(-2 * distance * distance);
      sum += values[u] * weight;
      squares += weight * weight;
      for (std::size_t i = adjacency.begin[u]; i < adjacency.begin[u + 1]; ++i) {
        const std::size_t w = adjacency.neighbour[i];
        if (reached_from[w] == v || !((mesh.vert[w].cP() - mesh.vert[v].cP()).Norm() < reach * length)) continue;
        reached_from[w] = v;
        found.push_back(w);
      }
    }
    result[v] = sum / std::sqrt(squares);
  }
  for (std::size_t v = 0; v < values.size(); ++v) result[v] = result[first[v]];
  return result;
}

}  // namespace mesh_tools
