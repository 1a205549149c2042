// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/library_neighborhoods.h>

#include <algorithm>

#include <filters/paper/paper_filter.h>
#include <geodesic_march.h>
#include <job.h>
#include <mesh/read_mesh.h>
#include <triangle_frames.h>
#include <vcg_core/mesh/vcglib_view.h>

#include <support/mesh_types.h>

namespace test_support {

namespace detail = vcg_core::detail;

struct LibraryNeighborhoods::Inside {
  DoubleMesh mesh;
  detail::MeshArrays arrays;
  detail::Array<detail::Index> index_of;
  detail::Array<detail::TriangleFrame<double>> frames;
  std::unique_ptr<detail::GeodesicMarch<double>> march;
};

LibraryNeighborhoods::LibraryNeighborhoods(const FlatMesh& mesh) : inside_(std::make_unique<Inside>()) {
  fill(inside_->mesh, mesh);
  const vcg_core::Progress no_progress;
  detail::Job job(no_progress, 1);
  inside_->arrays = detail::read_mesh(vcg_core::view_of(inside_->mesh), job);
  inside_->index_of = detail::vertex_of_host(inside_->arrays);
  const double e = inside_->arrays.topology.average_edge_length;
  inside_->frames = detail::triangle_frames(inside_->arrays, inside_->arrays.position, e, job);
  inside_->march = std::make_unique<detail::GeodesicMarch<double>>(inside_->arrays, inside_->frames, 1e-9);
}

LibraryNeighborhoods::~LibraryNeighborhoods() = default;

std::vector<std::size_t> LibraryNeighborhoods::of(std::size_t i, double cutoff) {
  detail::GeodesicMarch<double>& march = *inside_->march;
  march.run(inside_->index_of[i], cutoff + detail::march_margin, [](std::size_t) {});
  std::vector<std::size_t> result;
  for (const detail::Index v : march.reached())
    if (march.distance(v) < cutoff) result.push_back(inside_->arrays.host_vertex[v]);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace test_support
