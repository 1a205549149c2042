// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/noise.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <vcg/complex/algorithms/update/bounding.h>

#include <mesh_tools/random.h>

namespace mesh_tools {

namespace {

bool is_finite(const vcg::Point3d& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// For each vertex the first one at exactly its place: copies along the seam of a texture are one vertex of the
/// surface.
std::vector<std::size_t> first_in_place(const Mesh& mesh) {
  std::vector<std::size_t> first(mesh.vert.size());
  std::iota(first.begin(), first.end(), std::size_t(0));
  std::vector<std::size_t> order;
  for (const std::size_t v : first)
    if (!mesh.vert[v].IsD() && is_finite(mesh.vert[v].cP())) order.push_back(v);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return mesh.vert[a].cP() < mesh.vert[b].cP(); });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (mesh.vert[order[i]].cP() == mesh.vert[order[i - 1]].cP()) first[order[i]] = first[order[i - 1]];
  return first;
}

}  // namespace

std::vector<vcg::Point3d> vertex_normals(const Mesh& mesh) {
  const std::vector<std::size_t> first = first_in_place(mesh);
  std::vector<vcg::Point3d> normals(mesh.vert.size(), vcg::Point3d(0, 0, 0));
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    vcg::Point3d normal = (face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0));
    const double length = normal.Norm();
    if (!(length > 0)) continue;
    normal /= length;
    for (int k = 0; k < 3; ++k) {
      const vcg::Point3d a = face.cP((k + 1) % 3) - face.cP(k), b = face.cP((k + 2) % 3) - face.cP(k);
      normals[first[vcg::tri::Index(mesh, face.cV(k))]] += normal * std::atan2((a ^ b).Norm(), a * b);
    }
  }
  for (vcg::Point3d& normal : normals) {
    const double length = normal.Norm();
    normal = length > 1e-12 ? normal / length : vcg::Point3d(0, 0, 0);
  }
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = normals[first[v]];
  return normals;
}

void add_noise(Mesh& mesh, double level, std::uint64_t seed, NoiseDirection direction) {
  if (!(level >= 0) || !std::isfinite(level))
    throw std::invalid_argument("noise level is " + std::to_string(level) + "; it must be finite and at least 0");
  const double deviation = level * average_edge_length(mesh);
  const std::vector<vcg::Point3d> normals = vertex_normals(mesh);
  const std::vector<std::size_t> first = first_in_place(mesh);
  std::vector<vcg::Point3d> displacement(mesh.vert.size());
  Random random(seed);
  for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
    if (mesh.vert[i].IsD()) continue;
    const double distance = deviation * random.normal();
    displacement[i] = (direction == NoiseDirection::normal ? normals[i] : random.direction()) * distance;
    mesh.vert[i].P() += displacement[first[i]];
  }
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
}

}  // namespace mesh_tools
