// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/noise.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <vcg/complex/algorithms/update/bounding.h>

#include <mesh_tools/random.h>

#include "correlated.h"

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

/// How a vertex moves: along `direction`, by `length` standard deviations.
struct Move {
  vcg::Point3d direction{0, 0, 0};
  double length = 0;
};

void require(bool allowed, const char* name, double value, const char* range) {
  if (!allowed || !std::isfinite(value))
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + "; it must be " + range);
}

void check(const NoiseModel& model) {
  constexpr char not_negative[] = "finite and at least 0";
  require(model.level >= 0, "noise level", model.level, not_negative);
  if (model.level_far) require(*model.level_far >= 0, "noise level at the far end", *model.level_far, not_negative);
  require(model.correlation >= 0, "correlation", model.correlation, not_negative);
  require(model.share > 0 && model.share <= 1, "share", model.share, "above 0 and at most 1");
  require(model.step >= 0, "step", model.step, not_negative);
  if (!is_finite(model.axis) || !(model.axis.Norm() > 0) || !std::isfinite(model.axis.Norm()))
    throw std::invalid_argument("axis must be a direction: finite and not 0");
  if (model.camera && !is_finite(*model.camera)) throw std::invalid_argument("camera must be a finite place");
}

std::vector<Move> draw_moves(const Mesh& mesh, const NoiseModel& model, const std::vector<vcg::Point3d>& normals) {
  std::vector<Move> moves(mesh.vert.size());
  Random random(model.seed);
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (mesh.vert[v].IsD()) continue;
    moves[v].length = random.normal();
    const bool is_along_normal = model.camera || model.direction == NoiseDirection::normal;
    moves[v].direction = is_along_normal ? normals[v] : random.direction();
  }
  return moves;
}

/// Moves along normals are correlated by their lengths, others as vectors.
void correlate_moves(const Mesh& mesh, double length, const std::vector<std::size_t>& first, const NoiseModel& model,
                     std::vector<Move>& moves) {
  std::vector<vcg::Point3d> field;
  field.reserve(moves.size());
  const bool as_vectors = !model.camera && model.direction == NoiseDirection::any;
  for (const Move& move : moves)
    field.push_back(as_vectors ? move.direction * move.length : vcg::Point3d(move.length, 0, 0));
  field = correlated(mesh, length, first, field);
  for (std::size_t v = 0; v < moves.size(); ++v)
    if (!as_vectors) {
      moves[v].length = field[v][0];
    } else if (const double norm = field[v].Norm(); norm > 0) {
      moves[v] = {field[v] / norm, norm};
    }
}

/// Of the cosine between ray and normal: slanted surfaces are not seen by a camera.
constexpr double least_cosine = 0.2;

/// Turns the moves into the rays of a depth camera, and makes them grow with distance and slant.
void follow_rays(const Mesh& mesh, const vcg::Point3d& camera, const std::vector<vcg::Point3d>& normals,
                 std::vector<Move>& moves) {
  double sum = 0, count = 0;
  for (const auto& vertex : mesh.vert) {
    if (vertex.IsD() || !is_finite(vertex.cP())) continue;
    sum += (vertex.cP() - camera).Norm();
    ++count;
  }
  const double mean = sum / count;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (mesh.vert[v].IsD() || !is_finite(mesh.vert[v].cP())) continue;
    const vcg::Point3d ray = mesh.vert[v].cP() - camera;
    const double distance = ray.Norm();
    if (!(distance > 0)) throw std::invalid_argument("the camera lies at vertex " + std::to_string(v));
    const double cosine = normals[v].SquaredNorm() > 0 ? std::abs(normals[v] * ray) / distance : 1;
    moves[v].direction = ray / distance;
    moves[v].length *= distance * distance / (mean * mean) / std::max(cosine, least_cosine);
  }
}

/// By vertex, in |e|.
std::vector<double> levels(const Mesh& mesh, const NoiseModel& model) {
  std::vector<double> level(mesh.vert.size(), model.level);
  if (!model.level_far) return level;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& vertex : mesh.vert) {
    if (vertex.IsD()) continue;
    low = std::min(low, vertex.cP() * model.axis);
    high = std::max(high, vertex.cP() * model.axis);
  }
  for (std::size_t v = 0; v < level.size() && high > low; ++v) {
    const double part = (mesh.vert[v].cP() * model.axis - low) / (high - low);
    level[v] = (1 - part) * model.level + part * *model.level_far;
  }
  return level;
}

/// Draws from numbers of its own, so that the moves of those that move do not depend on the share.
void choose_vertices(const NoiseModel& model, std::vector<double>& deviation) {
  Random random(~model.seed);
  for (double& value : deviation)
    if (!(random.uniform() < model.share)) value = 0;
}

void round_to_steps(Mesh& mesh, vcg::Point3d axis, double step) {
  axis /= axis.Norm();
  for (auto& vertex : mesh.vert) {
    if (vertex.IsD() || !(step > 0)) continue;
    const double place = vertex.cP() * axis;
    vertex.P() += axis * (std::round(place / step) * step - place);
  }
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
  NoiseModel model;
  model.level = level;
  model.seed = seed;
  model.direction = direction;
  add_noise(mesh, model);
}

void add_noise(Mesh& mesh, const NoiseModel& model) {
  check(model);
  const double edge = average_edge_length(mesh);
  const std::vector<vcg::Point3d> normals = vertex_normals(mesh);
  const std::vector<std::size_t> first = first_in_place(mesh);
  std::vector<Move> moves = draw_moves(mesh, model, normals);
  if (model.correlation > 0) correlate_moves(mesh, model.correlation * edge, first, model, moves);
  if (model.camera) follow_rays(mesh, *model.camera, normals, moves);
  std::vector<double> deviation = levels(mesh, model);
  for (double& level : deviation) level *= edge;
  if (model.share < 1) choose_vertices(model, deviation);
  std::vector<vcg::Point3d> displacement(moves.size());
  for (std::size_t v = 0; v < moves.size(); ++v)
    displacement[v] = moves[v].direction * (deviation[v] * moves[v].length);
  for (std::size_t v = 0; v < moves.size(); ++v)
    if (!mesh.vert[v].IsD()) mesh.vert[v].P() += displacement[first[v]];
  if (model.step > 0) round_to_steps(mesh, model.axis, model.step * edge);
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
}

}  // namespace mesh_tools
