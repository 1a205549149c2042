// SPDX-License-Identifier: GPL-3.0-or-later
#include "training_mesh.h"

#include <array>

#include <mesh_tools/shapes.h>
#include <vcg/complex/algorithms/clean.h>

#include "block_solid.h"
#include "decimation.h"
#include "height_field.h"
#include "implicit_solid.h"
#include "organic_shape.h"
#include "training_noise.h"

namespace training {

namespace {

using mesh_tools::Mesh;
using mesh_tools::Random;

/// Takes away what lies beyond a random plane, and some balls: borders and holes.
void cut_open(Mesh& mesh, Random& random) {
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
  const double size = mesh.bbox.Diag();
  const vcg::Point3d normal = random.direction();
  const double offset = between(random, 0.0, 0.25) * size;
  std::vector<std::pair<vcg::Point3d, double>> holes;
  for (double k = between(random, 0, 5); k > 1; --k)
    holes.emplace_back(mesh.vert[static_cast<std::size_t>(random.uniform() * mesh.vert.size())].P(),
                       between(random, 0.02, 0.08) * size);
  std::vector<vcg::Point3d> vertices;
  std::vector<std::array<std::size_t, 3>> faces;
  for (auto& v : mesh.vert) vertices.push_back(v.P());
  for (auto& f : mesh.face) {
    const vcg::Point3d c = (f.P(0) + f.P(1) + f.P(2)) / 3;
    bool keep = normal * (c - mesh.bbox.Center()) < offset;
    for (const auto& [center, radius] : holes) keep = keep && (c - center).Norm() > radius;
    if (keep)
      faces.push_back({vcg::tri::Index(mesh, f.V(0)), vcg::tri::Index(mesh, f.V(1)), vcg::tri::Index(mesh, f.V(2))});
  }
  build(mesh, vertices, faces);
}

Mesh generated(Random& random) {
  static const std::vector<std::pair<const char*, double>> names = {
      {"cad_part", 2},    {"stepped_block", 1}, {"cube", 1},   {"thin_plate", 1},
      {"thin_sheets", 1}, {"graded_cube", 3},   {"sphere", 2}, {"torus", 1.5}};
  std::vector<double> chances;
  for (const auto& [name, chance] : names) chances.push_back(chance);
  return mesh_tools::make_shape(names[choose(random, chances)].first,
                                static_cast<std::size_t>(between(random, 1500, 9000)));
}

constexpr std::size_t fewest_vertices = 800;

TrainingMesh with_own_noise(VolumeSurface surface, const char* family) {
  return {std::move(surface.mesh), std::move(surface.normal), family};
}

/// A shape; surfaces of noisy volumes with their normals.
TrainingMesh make_shape(Random& random) {
  switch (choose(random, {0.27, 0.16, 0.18, 0.08, 0.16, 0.04, 0.11})) {
    case 0:
      return {organic_shape(random), {}, "organic"};
    case 1:
      return {block_solid(random), {}, "blocks"};
    case 2:
      return {generated(random), {}, "generated"};
    case 3:
      return {isosurface(random), {}, "isosurface"};
    case 4:
      return {height_field(random), {}, "height field"};
    case 5:
      return with_own_noise(fused_surface(random), "fused");
    default:
      return with_own_noise(label_surface(random), "labels");
  }
}

}  // namespace

std::size_t choose(Random& random, const std::vector<double>& chances) {
  double sum = 0;
  for (const double chance : chances) sum += chance;
  double x = random.uniform() * sum;
  for (std::size_t i = 0; i < chances.size(); ++i)
    if ((x -= chances[i]) < 0) return i;
  return chances.size() - 1;
}

double between(Random& random, double least, double most) { return least + (most - least) * random.uniform(); }

std::vector<vcg::Point3d> face_normals(const Mesh& mesh) {
  std::vector<vcg::Point3d> normals;
  for (const auto& f : mesh.face) {
    const vcg::Point3d n = (f.cP(1) - f.cP(0)) ^ (f.cP(2) - f.cP(0));
    normals.push_back(n.Norm() > 0 ? n / n.Norm() : vcg::Point3d(0, 0, 0));
  }
  return normals;
}

void build(Mesh& mesh, const std::vector<vcg::Point3d>& vertices,
           const std::vector<std::array<std::size_t, 3>>& faces) {
  Mesh fresh;
  vcg::tri::Allocator<Mesh>::AddVertices(fresh, vertices.size());
  vcg::tri::Allocator<Mesh>::AddFaces(fresh, faces.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) fresh.vert[v].P() = vertices[v];
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) fresh.face[f].V(k) = &fresh.vert[faces[f][static_cast<std::size_t>(k)]];
  vcg::tri::Clean<Mesh>::RemoveUnreferencedVertex(fresh);
  vcg::tri::Allocator<Mesh>::CompactEveryVector(fresh);
  vcg::tri::UpdateBounding<Mesh>::Box(fresh);
  mesh = std::move(fresh);
}

TrainingMesh make_training_mesh(std::uint64_t seed, std::size_t number) {
  Random random(seed * 1000003 + number);
  TrainingMesh result = make_shape(random);
  while (result.noisy.vert.size() < fewest_vertices) result = make_shape(random);  // the last box took all away
  if (!result.normal.empty()) return result;
  if (random.uniform() < 0.35) decimate(result.noisy, between(random, 0.35, 0.8), random);
  if (random.uniform() < 0.3) cut_open(result.noisy, random);
  result.normal = face_normals(result.noisy);
  add_some_noise(result.noisy, random);
  return result;
}

}  // namespace training
