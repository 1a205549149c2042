// SPDX-License-Identifier: GPL-3.0-or-later
#include "voxel_stairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <vcg_core/mesh/guided_measures.h>

#include "face_geometry.h"
#include "job.h"
#include "told_whole.h"

namespace vcg_core::detail {

namespace {

/// Faces whose normals are looked at, before all of the sample are.
constexpr std::size_t sampled_faces = 1024;
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
std::vector<Direction> find_directions(const std::vector<Vec3>& normals) {
  std::vector<Direction> directions;
  const std::size_t stride = std::max<std::size_t>(1, normals.size() / sampled_faces);
  for (std::size_t f = 0; f < normals.size(); f += stride) {
    const Vec3& normal = normals[f];
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
Axes refined(const Vec3& first, const Vec3& second, const std::vector<Vec3>& normals) {
  const Axes axes = {first, second, first.cross(second)};
  Axes sum;
  sum.fill(Vec3::Zero());
  for (const Vec3& normal : normals)
    for (std::size_t k = 0; k < 2; ++k) {
      const double cosine = normal.dot(axes[k]);
      if (std::abs(cosine) < 0.5 || !(normal.cross(axes[k]).norm() < same_direction)) continue;
      sum[k] += cosine > 0 ? normal : Vec3(-normal);
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

/// Finds equally spaced values along an axis of a grid: sets its `first` and `distance`. Whether there are any.
bool find_levels(const std::vector<Vec3>& positions, double edge_length, int k, VoxelGrid& grid) {
  std::vector<double> values;
  const Vec3 axis(grid.axis[k]);
  values.reserve(positions.size());
  for (const Vec3& position : positions) values.push_back(position.dot(axis));
  std::sort(values.begin(), values.end());
  const double tolerance = same_level * edge_length;
  std::vector<double> level = {values.front()};
  double smallest = std::numeric_limits<double>::infinity();
  for (const double value : values) {
    if (value - level.back() <= tolerance) continue;
    smallest = std::min(smallest, value - level.back());
    level.push_back(value);
  }
  if (static_cast<double>(level.size()) < least_levels || (level.back() - level.front()) / smallest > most_levels)
    return false;
  // The smallest gap is known to within the rounding of coordinates; the whole range, counted in it, is more exact.
  double index = 0;
  for (std::size_t i = 1; i < level.size(); ++i) {
    const double gaps = (level[i] - level[i - 1]) / smallest;
    if (std::abs(gaps - std::round(gaps)) > off_level * std::round(gaps)) return false;
    index += std::round(gaps);
  }
  grid.first[k] = level.front();
  grid.distance[k] = (level.back() - level.front()) / index;
  return true;
}

/// Of the levels that a vertex of the grid is on, one along each axis, which are not those of centres: a bit alone.
constexpr std::array<unsigned, 3> between_along = {1, 2, 4};

/// Sets where the grid's centres are. Whether nearly all vertices are half-way between two of them, along each axis
/// some.
bool find_centres(const CountParities& count, VoxelGrid& grid) {
  const ParityCounts counts = count(grid);
  // Along each axis the even levels may be those of the centres or those between them.
  const auto on_grid = [&](unsigned centres) {
    std::size_t sum = 0;
    for (const unsigned between : between_along) sum += counts[centres ^ between];
    return sum;
  };
  for (unsigned centres = 1; centres < 8; ++centres)
    if (on_grid(centres) > on_grid(grid.odd_centres)) grid.odd_centres = centres;
  const auto all = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  return static_cast<double>(on_grid(grid.odd_centres)) >= share_on_grid * all &&
         std::all_of(between_along.begin(), between_along.end(),
                     [&](unsigned between) { return counts[grid.odd_centres ^ between] > 0; });
}

std::optional<VoxelGrid> grid_along(const Axes& axes, const GridSample& sample, double edge_length,
                                    const CountParities& count) {
  VoxelGrid grid;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) grid.axis[k][i] = axes[static_cast<std::size_t>(k)][i];
    if (!find_levels(sample.position, edge_length, k, grid)) return std::nullopt;
  }
  return find_centres(count, grid) ? std::optional<VoxelGrid>(grid) : std::nullopt;
}

/// The grid of a whole mesh.
std::optional<VoxelGrid> find_grid(const MeshArrays& mesh, Job& job) {
  if (mesh.size() < least_vertices) return std::nullopt;
  GridSample sample;
  const std::size_t to_vertex = std::max<std::size_t>(1, mesh.size() / VoxelGridSample::usual_vertices);
  for (std::size_t v = 0; v < mesh.size(); v += to_vertex) sample.position.push_back(mesh.position[v]);
  const std::size_t to_face = std::max<std::size_t>(1, mesh.face.size() / VoxelGridSample::usual_normals);
  for (std::size_t f = 0; f < mesh.face.size(); f += to_face)
    sample.normal.push_back(direction_of_face(area_vector(mesh, mesh.position, f)));
  return find_voxel_grid(sample, mesh.topology.average_edge_length, [&](const VoxelGrid& grid) {
    ParityCounts counts{};
    job.serial(mesh.size(), [&](std::size_t v) { ++counts[parity_at(mesh.position[v], grid)]; });
    return counts;
  });
}

}  // namespace

unsigned parity_at(const Vec3& position, const VoxelGrid& grid) {
  unsigned parity = 0;
  for (int k = 0; k < 3; ++k) {
    const double index = (position.dot(Vec3(grid.axis[k])) - grid.first[k]) / grid.distance[k];
    const double whole = std::round(index);
    if (std::abs(index - whole) > off_level) return off_grid;
    if (std::fmod(std::abs(whole), 2) == 1) parity |= 1U << k;
  }
  return parity;
}

std::optional<VoxelGrid> find_voxel_grid(const GridSample& sample, double edge_length, const CountParities& count) {
  if (sample.position.empty()) return std::nullopt;
  const std::vector<Direction> directions = find_directions(sample.normal);
  if (directions.empty()) return std::nullopt;
  const auto along = [&](const Axes& axes) { return grid_along(axes, sample, edge_length, count); };
  if (std::optional<VoxelGrid> grid = along({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()})) return grid;
  int pairs = 0;
  for (std::size_t a = 0; a < directions.size(); ++a)
    for (std::size_t b = a + 1; b < directions.size(); ++b) {
      if (std::abs(directions[a].normal.dot(directions[b].normal)) > orthogonal) continue;
      if (++pairs > most_pairs) return std::nullopt;
      const Axes axes = refined(directions[a].normal, directions[b].normal, sample.normal);
      if (std::optional<VoxelGrid> grid = along(in_order(axes))) return grid;
    }
  return std::nullopt;
}

std::optional<VoxelStairs> find_voxel_stairs(const MeshArrays& mesh, Job& job) {
  const GuidedWhole* const told = told_whole(mesh);
  const std::optional<VoxelGrid> grid = told != nullptr ? told->grid : find_grid(mesh, job);
  if (!grid) return std::nullopt;
  VoxelStairs stairs;
  for (std::size_t k = 0; k < 3; ++k) {
    stairs.axis[k] = Vec3(grid->axis[k]);
    stairs.step[k] = 2 * grid->distance[k];
  }
  stairs.pair.resize(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) {
    const unsigned between = parity_at(mesh.position[v], *grid) ^ grid->odd_centres;
    const auto found = std::find(between_along.begin(), between_along.end(), between);
    stairs.pair[v] = static_cast<std::uint8_t>(found - between_along.begin());
  });
  return stairs;
}

Array<double> deviations_by_stairs(const MeshArrays& mesh, const RingMeans& rings, const VoxelStairs& stairs,
                                   Job& job) {
  Array<Vec3> normal(mesh.size());
  job.serial(mesh.size(), [&](std::size_t v) {
    normal[v].setZero();
    for (Index s = mesh.topology.star_begin[v]; s < mesh.topology.star_begin[v + 1]; ++s)
      normal[v] += area_vector(mesh, mesh.position, mesh.topology.star[s] / 3);
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
