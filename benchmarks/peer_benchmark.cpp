// SPDX-License-Identifier: GPL-3.0-or-later
// What the neighbourhoods cost by other means, on the same mesh and core: all report pairs (source, vertex nearer than
// rho). The slow ones do every n-th source, and count the pairs of those.

#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include <benchmark/benchmark.h>
#include <vcg/complex/complex.h>

// Not by itself: it builds on the one above.
#include <vcg/complex/algorithms/geodesic.h>
#include <nanoflann.hpp>

#include "bench_mesh.h"

namespace {

using vcg_core::detail::Index;
using vcg_core::detail::MeshArrays;

void count(benchmark::State& state, std::size_t pairs) {
  state.counters["pairs"] = static_cast<double>(pairs);
  state.counters["pairs_per_second"] =
      benchmark::Counter(static_cast<double>(pairs), benchmark::Counter::kIsIterationInvariantRate);
}

/// Points as nanoflann wants them, in |e| and single precision.
struct Cloud {
  std::vector<float> xyz;
  std::size_t kdtree_get_point_count() const { return xyz.size() / 3; }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return xyz[3 * i + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// nanoflann's radius query: Euclidean balls of the same radius.
void nanoflann_radius(benchmark::State& state) {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3>;
  const bench::Arrays& arrays = bench::noisy_arrays({});
  const auto rho = static_cast<float>(state.range(0));
  Cloud cloud;
  for (const auto& p : arrays.mesh.position)
    for (int axis = 0; axis < 3; ++axis)
      cloud.xyz.push_back(static_cast<float>(p[axis] / arrays.mesh.topology.average_edge_length));
  std::size_t pairs = 0;
  for (auto _ : state) {
    const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    std::vector<std::pair<std::uint32_t, float>> found;
    nanoflann::SearchParams search;
    search.sorted = false;
    pairs = 0;
    for (std::size_t i = 0; i < cloud.kdtree_get_point_count(); ++i)
      pairs += tree.radiusSearch(&cloud.xyz[3 * i], rho * rho, found, search);
    benchmark::DoNotOptimize(pairs);
  }
  count(state, pairs);
}
BENCHMARK(nanoflann_radius)->Arg(4)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3f, vcg::vertex::Normal3f, vcg::vertex::VFAdj,
                                  vcg::vertex::Mark, vcg::vertex::Qualityf, vcg::vertex::BitFlags> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::VFAdj, vcg::face::BitFlags> {};
class PeerMesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

/// vcglib's Geodesic, used for each vertex.
void vcglib_geodesic(benchmark::State& state) {
  constexpr std::size_t stride = 50;
  const bench::Arrays& arrays = bench::noisy_arrays({});
  PeerMesh mesh;
  auto v = vcg::tri::Allocator<PeerMesh>::AddVertices(mesh, arrays.mesh.size());
  for (const auto& p : arrays.mesh.position) {
    const auto q = (p / arrays.mesh.topology.average_edge_length).eval();
    (v++)->P() = vcg::Point3f(static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]));
  }
  for (const auto& f : arrays.mesh.face) vcg::tri::Allocator<PeerMesh>::AddFace(mesh, f[0], f[1], f[2]);
  vcg::tri::UpdateTopology<PeerMesh>::VertexFace(mesh);
  vcg::tri::EuclideanDistance<PeerMesh> euclidean;
  const auto rho = static_cast<float>(state.range(0));
  std::size_t pairs = 0;
  for (auto _ : state) {
    pairs = 0;
    for (std::size_t i = 0; i < mesh.vert.size(); i += stride) {
      std::vector<PeerMesh::VertexPointer> within;
      vcg::tri::Geodesic<PeerMesh>::Compute(mesh, {&mesh.vert[i]}, euclidean, rho, &within);
      pairs += within.size();
    }
    benchmark::DoNotOptimize(pairs);
  }
  count(state, pairs);
}
BENCHMARK(vcglib_geodesic)->Arg(4)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

/// Dijkstra's algorithm along edges up to rho, in single precision with lengths prepared: the plain neighbourhood.
class EdgeDijkstra {
 public:
  explicit EdgeDijkstra(const MeshArrays& mesh) : distance_(mesh.size(), unreached), begin_(mesh.size() + 1, 0) {
    for (Index v = 0; v < mesh.size(); ++v) {
      for (Index s = mesh.topology.star_begin[v]; s < mesh.topology.star_begin[v + 1]; ++s) {
        const Index to = vertex_of(mesh, vcg_core::detail::next_in_face(mesh.topology.star[s]));
        const double length = (mesh.position[to] - mesh.position[v]).norm() / mesh.topology.average_edge_length;
        edge_.push_back({to, static_cast<float>(length)});
      }
      begin_[v + 1] = static_cast<Index>(edge_.size());
    }
  }

  std::size_t ball(Index source, float rho) {
    for (const Index v : reached_) distance_[v] = unreached;
    reached_.assign(1, source);
    distance_[source] = 0;
    front_.push({0.0f, source});
    std::size_t inside = 0;
    while (!front_.empty()) {
      const auto [distance, v] = front_.top();
      front_.pop();
      if (distance > distance_[v]) continue;
      ++inside;
      for (Index k = begin_[v]; k < begin_[v + 1]; ++k) {
        const float to = distance + edge_[k].length;
        if (to >= rho || to >= distance_[edge_[k].to]) continue;
        if (distance_[edge_[k].to] == unreached) reached_.push_back(edge_[k].to);
        distance_[edge_[k].to] = to;
        front_.push({to, edge_[k].to});
      }
    }
    return inside;
  }

 private:
  static constexpr float unreached = std::numeric_limits<float>::max();
  struct Edge {
    Index to;
    float length;
  };
  using Entry = std::pair<float, Index>;
  std::vector<float> distance_;
  std::vector<Index> begin_;
  std::vector<Edge> edge_;
  std::vector<Index> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front_;
};

void edge_dijkstra(benchmark::State& state) {
  constexpr std::size_t stride = 4;
  const bench::Arrays& arrays = bench::noisy_arrays({});
  EdgeDijkstra dijkstra(arrays.mesh);
  std::size_t pairs = 0;
  for (auto _ : state) {
    pairs = 0;
    for (std::size_t i = 0; i < arrays.mesh.size(); i += stride)
      pairs += dijkstra.ball(static_cast<Index>(i), static_cast<float>(state.range(0)));
    benchmark::DoNotOptimize(pairs);
  }
  count(state, pairs);
}
BENCHMARK(edge_dijkstra)->Arg(4)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

}  // namespace
