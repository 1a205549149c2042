// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/split_mesh.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <utility>

namespace test_support {

SplitMesh split(const FlatMesh& mesh, const std::vector<std::size_t>& chart, unsigned seed) {
  using Corner = std::pair<std::size_t, std::size_t>;  // vertex and chart
  std::map<Corner, std::size_t> copy;
  std::vector<std::size_t> original;
  const auto add = [&](const Corner& corner) {
    if (copy.emplace(corner, original.size()).second) original.push_back(corner.first);
  };
  std::vector<bool> has_face(mesh.points.size(), false);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (const std::size_t v : mesh.faces[f]) {
      add({v, chart[f]});
      has_face[v] = true;
    }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (!has_face[v]) add({v, 0});

  std::vector<std::size_t> place(original.size());
  std::iota(place.begin(), place.end(), std::size_t(0));
  std::shuffle(place.begin(), place.end(), std::mt19937(seed));
  SplitMesh result;
  result.mesh.points.resize(original.size());
  result.original.resize(original.size());
  for (std::size_t k = 0; k < original.size(); ++k) {
    result.mesh.points[place[k]] = mesh.points[original[k]];
    result.original[place[k]] = original[k];
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Triangle triangle;
    for (int k = 0; k < 3; ++k) triangle[k] = place[copy.at({mesh.faces[f][k], chart[f]})];
    result.mesh.faces.push_back(triangle);
  }
  return result;
}

std::vector<std::size_t> random_charts(const FlatMesh& mesh, std::size_t count, unsigned seed) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> faces_at;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int k = 0; k < 3; ++k) faces_at[std::minmax(mesh.faces[f][k], mesh.faces[f][(k + 1) % 3])].push_back(f);
  std::mt19937 random(seed);
  std::vector<std::size_t> chart(mesh.faces.size(), count);
  std::vector<std::pair<std::size_t, std::size_t>> front;  // face and chart that it may get
  for (std::size_t c = 0; c < count; ++c) front.emplace_back(random() % mesh.faces.size(), c);
  while (!front.empty()) {
    std::swap(front[random() % front.size()], front.back());
    const auto [f, c] = front.back();
    front.pop_back();
    if (chart[f] != count) continue;
    chart[f] = c;
    for (int k = 0; k < 3; ++k)
      for (const std::size_t g : faces_at[std::minmax(mesh.faces[f][k], mesh.faces[f][(k + 1) % 3])])
        front.emplace_back(g, c);
  }
  return chart;
}

std::vector<std::size_t> single_faces(const FlatMesh& mesh) {
  std::vector<std::size_t> chart(mesh.faces.size());
  std::iota(chart.begin(), chart.end(), std::size_t(0));
  return chart;
}

}  // namespace test_support
