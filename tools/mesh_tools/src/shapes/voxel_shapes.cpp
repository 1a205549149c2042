// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/voxel_shapes.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <mesh_tools/shapes.h>

#include "patch.h"
#include "solid.h"
#include "voxel_volume.h"

namespace mesh_tools {

namespace {

constexpr char prefix[] = "voxel_";
constexpr int most_trials = 12;
/// Of the number of vertices.
constexpr double close_enough = 0.005;

std::string with_underscores(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// The closed shape behind a name.
std::string solid_of(const std::string& name) {
  const std::string wanted = with_underscores(name);
  std::string known;
  for (const Shape& shape : all_shapes()) {
    if (!shape.is_closed) continue;
    if (wanted == std::string(prefix) + shape.name) return shape.name;
    known += (known.empty() ? "" : ", ") + (prefix + std::string(shape.name));
  }
  throw std::invalid_argument("unknown shape '" + name + "'; of voxels there are " + known);
}

void check(const VoxelGrid& grid) {
  if (!(grid.slice_distance >= 1 && grid.slice_distance <= 6))
    throw std::invalid_argument("slice distance is " + std::to_string(grid.slice_distance) + "; allowed are 1 to 6");
  if (!std::isfinite(grid.tilt)) throw std::invalid_argument("tilt must be a finite number");
}

/// The width of voxels that gives about the wanted number of vertices: first guess from the area, then by trial.
double pixel_for(const shapes::Solid& solid, double wanted, double slice_distance) {
  const vcg::Point3d area = solid.shadows();
  double pixel = std::sqrt(((area[0] + area[1]) / slice_distance + area[2]) / wanted);
  double best = pixel, smallest_error = INFINITY;
  for (int trial = 0; trial < most_trials; ++trial) {
    const shapes::VoxelVolume volume(solid, pixel, slice_distance);
    const double ratio = static_cast<double>(volume.boundary_pairs()) / wanted, error = std::abs(ratio - 1);
    if (error < smallest_error) {
      smallest_error = error;
      best = pixel;
    }
    if (error < close_enough || ratio == 0) break;
    pixel *= std::sqrt(ratio);
  }
  return best;
}

}  // namespace

bool is_voxel_shape(const std::string& name) { return with_underscores(name).rfind(prefix, 0) == 0; }

VoxelShape make_voxel_shape(const std::string& name, std::size_t vertices, const VoxelGrid& grid) {
  check(grid);
  const shapes::Solid solid(solid_of(name), vertices, grid.tilt);
  VoxelShape shape;
  shape.pixel = pixel_for(solid, static_cast<double>(vertices), grid.slice_distance);
  const shapes::VoxelVolume volume(solid, shape.pixel, grid.slice_distance);
  shapes::extract_surface(volume, shape.surface);
  if (shape.surface.fn == 0)
    throw std::invalid_argument(name +
                                ": no voxel has its centre inside; more vertices or a smaller slice distance help");
  vcg::tri::Append<Mesh, Mesh>::MeshCopy(shape.truth, shape.surface);
  for (auto& vertex : shape.truth.vert) vertex.P() = solid.nearest(vertex.cP());
  shapes::finish_mesh(shape.truth);
  return shape;
}

}  // namespace mesh_tools
