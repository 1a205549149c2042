// SPDX-License-Identifier: GPL-3.0-or-later
#include "voxel_stairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "job.h"

namespace vcg_core::detail {

namespace {

/// Faces whose normals are looked at, and vertices whose coordinates are, before all are.
constexpr std::size_t sampled_faces = 1024;
constexpr std::size_t sampled_vertices = 4096;
/// Faces whose normals are averaged for the axes.
constexpr std::size_t averaged_faces = 65536;
/// Most pairs of orthogonal directions that are tried. Cylinders and bodies of revolution have many.
constexpr int most_pairs = 64;
/// Marching cubes at one level make some forty directions of triangles, opposite ones counted once.
constexpr std::size_t most_directions = 100;
/// Sine of the angle up to which two normals are one direction.
constexpr double same_direction = 2e-3;
/// Cosine up to which two directions are orthogonal.
constexpr double orthogonal = 2e-3;
/// Of |e|: coordinates as near as this are one level.
constexpr double same_level = 2e-3;
/// Of the distance of two levels: from a multiple of it, coordinates are off by less.
constexpr double off_level = 0.05;
/// A single voxel is a perfect octahedron.
constexpr std::size_t least_vertices = 64;
/// Share of the vertices that must be of the grid.
constexpr double share_on_grid = 0.995;
/// Levels that there are at least along each axis: one slice has its centres and what is half-way on both sides.
constexpr double least_levels = 3;
/// More levels than these are no grid that a volume could have.
constexpr double most_levels = 1 << 20;

/// Rings over which normals are averaged, for each time that the coarsest step is as long as the finest; up to so many.
constexpr double rings_a_step = 4;
constexpr double most_steps = 6;

struct Direction {
  Vec3 normal;
  std::size_t faces = 0;
};

/// The directions of the normals of some faces, the most frequent first; none if there are too many.
std::vector<Direction> find_directions(const FaceGeometry& faces) {
  std::vector<Direction> directions;
  const std::size_t stride = std::max<std::size_t>(1, faces.normal.size() / sampled_faces);
  for (std::size_t f = 0; f < faces.normal.size(); f += stride) {
    const Vec3& normal = faces.normal[f];
    if (normal.squaredNorm() == 0) continue;
    const auto same = [&](const Direction& d) { return d.normal.cross(normal).norm() < same_direction; };
    const auto found = std::find_if(directions.begin(), directions.end(), same);
    if (found != directions.end()) {
      ++found->faces;
    } else {
      if (directions.size() == most_directions) return {};
      directions.push_back({normal, 1});
    }
  }
  std::stable_sort(directions.begin(), directions.end(),
                   [](const Direction& a, const Direction& b) { return a.faces > b.faces; });
  return directions;
}

using Axes = std::array<Vec3, 3>;

/// Axes from two of them, by the mean of the normals that are nearly along each: a face's own normal is as exact as the
/// coordinates are fine, and the axes of a grid of hundreds of voxels have to be more exact. The third is the cross
/// product, for no face may be along it.
Axes refined(const Vec3& first, const Vec3& second, const FaceGeometry& faces) {
  const Axes axes = {first, second, first.cross(second)};
  Axes sum;
  sum.fill(Vec3::Zero());
  const std::size_t stride = std::max<std::size_t>(1, faces.normal.size() / averaged_faces);
  for (std::size_t f = 0; f < faces.normal.size(); f += stride)
    for (std::size_t k = 0; k < 2; ++k) {
      const double cosine = faces.normal[f].dot(axes[k]);
      if (std::abs(cosine) < 0.5 || !(faces.normal[f].cross(axes[k]).norm() < same_direction)) continue;
      sum[k] += cosine > 0 ? faces.normal[f] : Vec3(-faces.normal[f]);
    }
  for (std::size_t k = 0; k < 2; ++k) sum[k].normalize();
  sum[2] = sum[0].cross(sum[1]).normalized();
  return sum;
}

/// In the order and with the signs of x, y and z.
Axes in_order(Axes axes) {
  for (int k = 0; k < 3; ++k) {
    const auto more_along = [k](const Vec3& a, const Vec3& b) { return std::abs(a[k]) < std::abs(b[k]); };
    std::iter_swap(axes.begin() + k, std::max_element(axes.begin() + k, axes.end(), more_along));
    if (axes[k][k] < 0) axes[k] = -axes[k];
  }
  return axes;
}

/// Equally spaced values.
struct Levels {
  double first = 0;
  double distance = 0;  ///< 0: the values are not equally spaced

  /// Index of the level at a value; the nearest integer is that of the level, if there is one.
  double index_of(double value) const { return (value - first) / distance; }
};

Levels find_levels(const MeshArrays& mesh, const Vec3& axis) {
  std::vector<double> values;
  const std::size_t stride = std::max<std::size_t>(1, mesh.size() / sampled_vertices);
  for (std::size_t v = 0; v < mesh.size(); v += stride) values.push_back(mesh.position[v].dot(axis));
  std::sort(values.begin(), values.end());
  const double tolerance = same_level * mesh.topology.average_edge_length;
  std::vector<double> level = {values.front()};
  double smallest = std::numeric_limits<double>::infinity();
  for (const double value : values) {
    if (value - level.back() <= tolerance) continue;
    smallest = std::min(smallest, value - level.back());
    level.push_back(value);
  }
  if (static_cast<double>(level.size()) < least_levels || (level.back() - level.front()) / smallest > most_levels)
    return {};
  // The smallest gap is known to within the rounding of coordinates; the whole range, counted in it, is more exact.
  double index = 0;
  for (std::size_t i = 1; i < level.size(); ++i) {
    const double gaps = (level[i] - level[i - 1]) / smallest;
    if (std::abs(gaps - std::round(gaps)) > off_level * std::round(gaps)) return {};
    index += std::round(gaps);
  }
  return {level.front(), (level.back() - level.front()) / index};
}

/// Which of the levels along each axis a vertex is on: bit k tells whether it is an odd one along axis k; 8 if it is
/// not on levels.
int parity_at(const Vec3& position, const Axes& axes, const std::array<Levels, 3>& levels) {
  int parity = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double index = levels[k].index_of(position.dot(axes[k])), whole = std::round(index);
    if (std::abs(index - whole) > off_level) return 8;
    if (std::fmod(std::abs(whole), 2) == 1) parity |= 1 << k;
  }
  return parity;
}

std::optional<VoxelStairs> stairs_along(const MeshArrays& mesh, const Axes& axes, Job& job) {
  std::array<Levels, 3> levels;
  for (std::size_t k = 0; k < 3; ++k) {
    levels[k] = find_levels(mesh, axes[k]);
    if (levels[k].distance == 0) return std::nullopt;
  }
  Array<std::uint8_t> parity(mesh.size());
  std::array<std::size_t, 9> count{};
  job.serial(mesh.size(), [&](std::size_t v) {
    parity[v] = static_cast<std::uint8_t>(parity_at(mesh.position[v], axes, levels));
    ++count[parity[v]];
  });
  // Along each axis the even levels may be those of the centres or those between them.
  const auto on_grid = [&](std::size_t centres) {
    return count[centres ^ 1u] + count[centres ^ 2u] + count[centres ^ 4u];
  };
  std::size_t centres = 0;
  for (std::size_t other = 1; other < 8; ++other)
    if (on_grid(other) > on_grid(centres)) centres = other;
  if (!(static_cast<double>(on_grid(centres)) >= share_on_grid * static_cast<double>(mesh.size()))) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k)
    if (count[centres ^ (std::size_t(1) << k)] == 0) return std::nullopt;
  VoxelStairs stairs{axes, {}, std::move(parity)};
  for (std::size_t k = 0; k < 3; ++k) stairs.step[k] = 2 * levels[k].distance;
  job.serial(mesh.size(), [&](std::size_t v) {
    const std::size_t between = stairs.pair[v] ^ centres;
    stairs.pair[v] = between == 1 ? 0 : between == 2 ? 1 : between == 4 ? 2 : 3;
  });
  return stairs;
}

}  // namespace

std::optional<VoxelStairs> find_voxel_stairs(const MeshArrays& mesh, const FaceGeometry& faces, Job& job) {
  const std::vector<Direction> directions = find_directions(faces);
  if (directions.empty() || mesh.size() < least_vertices) return std::nullopt;
  if (std::optional<VoxelStairs> stairs = stairs_along(mesh, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, job))
    return stairs;
  int pairs = 0;
  for (std::size_t a = 0; a < directions.size(); ++a)
    for (std::size_t b = a + 1; b < directions.size(); ++b) {
      if (std::abs(directions[a].normal.dot(directions[b].normal)) > orthogonal) continue;
      if (++pairs > most_pairs) return std::nullopt;
      job.poll();
      const Axes axes = refined(directions[a].normal, directions[b].normal, faces);
      if (std::optional<VoxelStairs> stairs = stairs_along(mesh, in_order(axes), job)) return stairs;
    }
  return std::nullopt;
}

Array<double> deviations_by_stairs(const MeshArrays& mesh, const RingMeans& rings, const VoxelStairs& stairs,
                                   const FaceGeometry& faces, Job& job) {
  Array<Vec3> normal(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) {
    normal[v].setZero();
    for (Index s = mesh.topology.star_begin[v]; s < mesh.topology.star_begin[v + 1]; ++s) {
      const Index f = mesh.topology.star[s] / 3;
      normal[v] += faces.normal[f] * faces.area[f];
    }
  });
  const auto [finest, widest] = std::minmax_element(stairs.step.begin(), stairs.step.end());
  const int times = static_cast<int>(std::ceil(rings_a_step * std::min(*widest / *finest, most_steps)));
  normal = low_pass(rings, std::move(normal), times, job);
  Array<double> deviation(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) {
    const std::size_t k = stairs.pair[v];
    const double length = normal[v].norm();
    deviation[v] =
        k < 3 && length > 0 ? std::abs(normal[v].dot(stairs.axis[k])) / length * stairs.step[k] / std::sqrt(12.0) : 0;
  });
  return deviation;
}

}  // namespace vcg_core::detail
