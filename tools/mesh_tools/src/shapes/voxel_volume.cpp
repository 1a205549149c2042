// SPDX-License-Identifier: GPL-3.0-or-later
#include "voxel_volume.h"

#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

#include <vcg/complex/algorithms/create/marching_cubes.h>

#include "patch.h"

namespace mesh_tools::shapes {

namespace {

/// Where the middle of the box lies between two centres of voxels: nothing of a shape falls on a centre.
constexpr std::array<double, 3> offset = {0.1367, 0.2913, 0.4189};

}  // namespace

VoxelVolume::VoxelVolume(const Solid& solid, double pixel, double slice_distance) {
  const vcg::Box3d& box = solid.box();
  for (int axis = 0; axis < 3; ++axis) {
    const double step = axis == 2 ? pixel * slice_distance : pixel;
    const int half = static_cast<int>(std::ceil(box.Dim()[axis] / 2 / step)) + 2;
    for (int i = -half; i <= half; ++i) centres_[axis].push_back(box.Center()[axis] + (i + offset[axis]) * step);
    size_[axis] = 2 * half + 1;
  }
  inside_ = solid.contains(centres_[0], centres_[1], centres_[2]);
}

std::size_t VoxelVolume::boundary_pairs() const {
  std::size_t pairs = 0;
  for (int j = 0; j + 1 < size_[1]; ++j)
    for (int i = 0; i + 1 < size_[0]; ++i)
      for (int k = 0; k + 1 < size_[2]; ++k) {
        const bool here = at(i, j, k);
        pairs += (here != at(i + 1, j, k)) + (here != at(i, j + 1, k)) + (here != at(i, j, k + 1));
      }
  return pairs;
}

namespace {

/// What vcglib's marching cubes ask for: the field, and the vertex on an edge of the grid. Cells come slice by slice.
class SliceWalker {
 public:
  SliceWalker(const VoxelVolume& volume, Mesh& mesh) : volume_(volume), mesh_(mesh), pixels_(pixels_of(volume)) {
    for (auto* edges : {&x_edges_[0], &x_edges_[1], &y_edges_[0], &y_edges_[1], &z_edges_})
      edges->assign(pixels_, none);
  }

  void next_slice() {
    for (auto* edges : {&x_edges_, &y_edges_}) {
      std::swap((*edges)[0], (*edges)[1]);
      (*edges)[1].assign(pixels_, none);
    }
    z_edges_.assign(pixels_, none);
    ++slice_;
  }

  /// Negative inside, so that faces look outwards. Of unequal size, so that no face of a cell is undecided: voxels
  /// inside that meet at an edge only stay apart.
  double V(int i, int j, int k) const { return volume_.at(i, j, k) ? -1 : 2; }

  void GetXIntercept(const vcg::Point3i& a, const vcg::Point3i& b, Mesh::VertexPointer& vertex) {
    vertex = vertex_at(x_edges_[a[2] - slice_], a, b);
  }
  void GetYIntercept(const vcg::Point3i& a, const vcg::Point3i& b, Mesh::VertexPointer& vertex) {
    vertex = vertex_at(y_edges_[a[2] - slice_], a, b);
  }
  void GetZIntercept(const vcg::Point3i& a, const vcg::Point3i& b, Mesh::VertexPointer& vertex) {
    vertex = vertex_at(z_edges_, a, b);
  }
  /// Asked for only where faces of a cell are decided differently, which unequal values rule out.
  bool Exist(const vcg::Point3i&, const vcg::Point3i&, Mesh::VertexPointer&) const { return false; }

 private:
  using Edges = std::vector<std::ptrdiff_t>;
  static constexpr std::ptrdiff_t none = -1;

  static std::size_t pixels_of(const VoxelVolume& volume) {
    return static_cast<std::size_t>(volume.size()[0]) * static_cast<std::size_t>(volume.size()[1]);
  }

  Mesh::VertexPointer vertex_at(Edges& edges, const vcg::Point3i& a, const vcg::Point3i& b) {
    std::ptrdiff_t& index = edges[static_cast<std::size_t>(a[1]) * volume_.size()[0] + static_cast<std::size_t>(a[0])];
    if (index == none) {
      index = static_cast<std::ptrdiff_t>(mesh_.vert.size());
      vcg::tri::Allocator<Mesh>::AddVertex(mesh_,
                                           (volume_.centre(a[0], a[1], a[2]) + volume_.centre(b[0], b[1], b[2])) / 2);
    }
    return &mesh_.vert[static_cast<std::size_t>(index)];
  }

  const VoxelVolume& volume_;
  Mesh& mesh_;
  std::size_t pixels_;
  int slice_ = 0;
  std::array<Edges, 2> x_edges_, y_edges_;  // of the lower and the upper slice
  Edges z_edges_;
};

}  // namespace

void extract_surface(const VoxelVolume& volume, Mesh& mesh) {
  SliceWalker walker(volume, mesh);
  vcg::tri::MarchingCubes<Mesh, SliceWalker> cubes(mesh, walker);
  cubes.Initialize();
  const std::array<int, 3>& size = volume.size();
  for (int k = 0; k + 1 < size[2]; ++k) {
    for (int j = 0; j + 1 < size[1]; ++j)
      for (int i = 0; i + 1 < size[0]; ++i) cubes.ProcessCell({i, j, k}, {i + 1, j + 1, k + 1});
    walker.next_slice();
  }
  cubes.Finalize();
  finish_mesh(mesh);
}

}  // namespace mesh_tools::shapes
