// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "sine_field.h"
#include "training_mesh.h"

namespace training {

namespace {

using mesh_tools::Mesh;
using mesh_tools::Random;

int whole(Random& random, int count) { return count <= 1 ? 0 : static_cast<int>(random.uniform() * count); }

/// Unit cells that are inside or outside.
class Cells {
 public:
  explicit Cells(Random& random)
      : size_{20 + whole(random, 22), 16 + whole(random, 20), 8 + whole(random, 18)},
        inside_(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]), 0) {
    set_box(random, true, 8);
    for (int boxes = 1 + whole(random, 5); boxes > 0; --boxes) {
      const double thin = random.uniform();
      set_box(random, random.uniform() < 0.6, thin < 0.15 ? 1 : thin < 0.3 ? 2 : 4);
    }
  }

  const std::array<int, 3>& size() const { return size_; }
  bool inside(const std::array<int, 3>& cell) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (cell[k] < 0 || cell[k] >= size_[k]) return false;
    return inside_[index(cell)] != 0;
  }

 private:
  std::size_t index(const std::array<int, 3>& c) const {
    return static_cast<std::size_t>((c[2] * size_[1] + c[1]) * size_[0] + c[0]);
  }
  void set_box(Random& random, bool inside, int least_width) {
    std::array<int, 3> begin{}, end{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int width = std::min(size_[k], least_width + whole(random, size_[k] - least_width));
      begin[k] = whole(random, size_[k] - width + 1);
      end[k] = begin[k] + width;
    }
    for (int z = begin[2]; z < end[2]; ++z)
      for (int y = begin[1]; y < end[1]; ++y)
        for (int x = begin[0]; x < end[0]; ++x) inside_[index({x, y, z})] = inside;
  }

  std::array<int, 3> size_;
  std::vector<char> inside_;
};

Mesh surface_of(const Cells& cells, Random& random) {
  std::vector<vcg::Point3d> vertices;
  std::vector<std::array<std::size_t, 3>> faces;
  std::map<std::array<int, 3>, std::size_t> number;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = number.try_emplace(at, vertices.size());
    if (is_new) vertices.emplace_back(at[0], at[1], at[2]);
    return place->second;
  };
  const std::size_t diagonals = choose(random, {1, 1, 1});
  for (int z = 0; z < cells.size()[2]; ++z)
    for (int y = 0; y < cells.size()[1]; ++y)
      for (int x = 0; x < cells.size()[0]; ++x)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            const std::array<int, 3> cell{x, y, z};
            std::array<int, 3> other = cell;
            other[axis] += side == 1 ? 1 : -1;
            if (!cells.inside(cell) || cells.inside(other)) continue;
            std::array<int, 3> corner = cell;
            corner[axis] += side;
            std::array<std::size_t, 4> quad{};
            const std::size_t u = (axis + 1) % 3, w = (axis + 2) % 3;
            for (std::size_t k = 0; k < 4; ++k) {
              std::array<int, 3> at = corner;
              at[u] += k == 1 || k == 2;
              at[w] += k >= 2;
              quad[k] = vertex(at);
            }
            if (side == 0) std::swap(quad[1], quad[3]);
            const bool turn = diagonals == 0 ? random.uniform() < 0.5 : diagonals == 1 ? (x + y + z) % 2 == 0 : true;
            const std::size_t first = turn ? 0 : 1;
            faces.push_back({quad[first], quad[first + 1], quad[first + 2]});
            faces.push_back({quad[first], quad[first + 2], quad[(first + 3) % 4]});
          }
  Mesh mesh;
  build(mesh, vertices, faces);
  return mesh;
}

/// Moves vertices within their faces: within the plane, or along the edge, or not at all.
void jitter(Mesh& mesh, double most, Random& random) {
  std::vector<std::array<bool, 3>> fixed(mesh.vert.size());
  for (auto& f : mesh.face) {
    const vcg::Point3d n = (f.P(1) - f.P(0)) ^ (f.P(2) - f.P(0));
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        if (std::abs(n[axis]) > 0.5) fixed[vcg::tri::Index(mesh, f.V(k))][static_cast<std::size_t>(axis)] = true;
  }
  for (std::size_t v = 0; v < mesh.vert.size(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      const double step = between(random, -most, most);
      if (!fixed[v][static_cast<std::size_t>(axis)]) mesh.vert[v].P()[axis] += step;
    }
}

void warp(Mesh& mesh, Random& random) {
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
  const vcg::Point3d center = mesh.bbox.Center();
  const double size = std::max({mesh.bbox.DimX(), mesh.bbox.DimY(), mesh.bbox.DimZ()});
  const auto sometimes = [&](double chance, double value) { return random.uniform() < chance ? value : 0.0; };
  const double twist = sometimes(0.4, between(random, -1.25, 1.25));
  const double taper = sometimes(0.4, between(random, -0.6, 0.6));
  const double bend = sometimes(0.5, between(random, 0.5, 2.5));
  const double shear = sometimes(0.3, between(random, -1, 1));
  SineField waves;
  if (random.uniform() < 0.5) waves.add(random, 3, between(random, 0.05, 0.11), 5);
  for (auto& v : mesh.vert) {
    vcg::Point3d p = (v.P() - center) / size;
    const double angle = twist * p[2];
    p = {p[0] * std::cos(angle) - p[1] * std::sin(angle), p[0] * std::sin(angle) + p[1] * std::cos(angle), p[2]};
    p[1] *= 1 + taper * p[0];
    p[2] *= 1 + taper * p[0];
    if (bend > 0) {
      const double radius = 1 / bend + p[2], turn = bend * p[0];
      p[0] = radius * std::sin(turn);
      p[2] = radius * std::cos(turn) - 1 / bend;
    }
    p += waves(p);
    p[0] += shear * p[1];
    v.P() = p;
  }
}

}  // namespace

Mesh block_solid(Random& random) {
  Mesh mesh = surface_of(Cells(random), random);
  if (random.uniform() < 0.7) jitter(mesh, between(random, 0, 0.35), random);
  if (random.uniform() < 0.7) warp(mesh, random);
  return mesh;
}

}  // namespace training
