// SPDX-License-Identifier: GPL-3.0-or-later
#include "voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include <vcg_core/mesh/guided_measures.h>

#include "bucket_file.h"

namespace tiles {
namespace {

/// @param size  bytes of a number
Point point_at(const char* raw, std::size_t size) {
  Point p{};
  for (std::size_t k = 0; k < 3; ++k) {
    float narrow = 0;
    std::memcpy(size == sizeof narrow ? static_cast<void*>(&narrow) : &p[k], raw + k * size, size);
    if (size == sizeof narrow) p[k] = narrow;
  }
  return p;
}

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Zero without area.
Point normal_of(const Point& a, const Point& b, const Point& c) {
  const Point p = difference(b, a), q = difference(c, a);
  Point n = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

/// The vertices of some cells, and the normals of the faces that lie in one of them with all three corners.
class GridSampler {
 public:
  explicit GridSampler(std::size_t real_size) : real_size_(real_size) {}

  void add(const BucketPart& cell) {
    std::vector<Point> place;
    for (std::size_t i = 0; i < cell.vertex.size(); ++i)
      place.push_back(point_at(cell.position.data() + i * 3 * real_size_, real_size_));
    sample.vertices.insert(sample.vertices.end(), place.begin(), place.end());
    for (const BucketFace& face : cell.face) {
      Point corner[3];
      bool is_whole = true;
      for (std::size_t k = 0; k < 3 && is_whole; ++k) {
        const auto found = std::find(cell.vertex.begin(), cell.vertex.end(), face.vertex[k]);
        is_whole = found != cell.vertex.end();
        if (is_whole) corner[k] = place[static_cast<std::size_t>(found - cell.vertex.begin())];
      }
      if (is_whole) sample.normals.push_back(normal_of(corner[0], corner[1], corner[2]));
    }
  }

  vcg_core::VoxelGridSample sample;

 private:
  std::size_t real_size_;
};

void thin_out(std::vector<Point>& points, std::size_t wanted) {
  const std::size_t stride = std::max<std::size_t>(1, points.size() / wanted);
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) points[count++] = points[i];
  points.resize(count);
}

/// From cells that are spread evenly over the tiles.
vcg_core::VoxelGridSample sample_cells(const Plan& plan) {
  std::size_t cells = 0;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile)
    cells += BucketFile(plan.bucket_path(tile), plan.real_size).cells();
  const double in_cell = static_cast<double>(plan.faces) / static_cast<double>(std::max<std::size_t>(1, cells));
  const auto stride =
      static_cast<std::size_t>(std::max(1.0, static_cast<double>(cells) * std::max(1.0, in_cell) /
                                                 static_cast<double>(vcg_core::VoxelGridSample::usual_normals)));
  GridSampler sampler(plan.real_size);
  std::size_t at = 0;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    const BucketFile bucket(plan.bucket_path(tile), plan.real_size);
    for (std::size_t i = 0; i < bucket.cells(); ++i, ++at) {
      if (at % stride != 0) continue;
      BucketPart part;
      bucket.read(i, i + 1, part);
      sampler.add(part);
    }
  }
  thin_out(sampler.sample.vertices, vcg_core::VoxelGridSample::usual_vertices);
  return std::move(sampler.sample);
}

}  // namespace

std::optional<vcg_core::VoxelGrid> find_voxel_grid(const LargeMesh& mesh, const Plan& plan) {
  return vcg_core::find_voxel_grid(sample_cells(plan), plan.average_edge_length, [&](const vcg_core::VoxelGrid& grid) {
    vcg_core::VoxelLevelCounts counts{};
    std::vector<Point> position(1 << 14);
    VertexStream stream(mesh);
    while (const std::size_t count = stream.read(position))
      for (std::size_t i = 0; i < count; ++i) ++counts[vcg_core::voxel_levels(position[i], grid)];
    return counts;
  });
}

}  // namespace tiles
