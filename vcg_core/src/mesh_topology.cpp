// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_topology.h"

#include <algorithm>

#include <Eigen/Geometry>

#include <vcg_core/errors.h>

#include "face_area.h"
#include "job.h"

namespace vcg_core::detail {

namespace {

bool has_repeated_vertex(const std::array<Index, 3>& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

void find_stars(const RawMesh& mesh, MeshTopology& topology, Job& job) {
  topology.star_begin.assign(mesh.position.size() + 2, 0);
  // Counts go two places up: the fill below moves each offset to its final place as it goes.
  Index* const count = topology.star_begin.data() + 2;
  job.serial(mesh.face.size(), [&](std::size_t f) {
    if (has_repeated_vertex(mesh.face[f])) return;
    for (const Index v : mesh.face[f]) ++count[v];
  });
  job.serial(mesh.position.size(), [&](std::size_t v) { topology.star_begin[v + 2] += topology.star_begin[v + 1]; });
  topology.star.resize(3 * mesh.face.size());
  Index* const end_of = topology.star_begin.data() + 1;
  job.serial(mesh.face.size(), [&](std::size_t f) {
    if (has_repeated_vertex(mesh.face[f])) return;
    for (Index k = 0; k < 3; ++k) topology.star[end_of[mesh.face[f][k]]++] = static_cast<Index>(3 * f + k);
  });
  topology.star_begin.pop_back();
  topology.star.resize(topology.star_begin.back());
}

enum VertexKind : std::uint8_t { on_border = 1, non_manifold = 2 };

std::uint8_t kind_of_edge(std::size_t faces) { return faces == 1 ? on_border : faces > 2 ? non_manifold : 0; }

struct EdgeSums {
  double length = 0;
  std::size_t edges = 0;
};

/// Goes through the edges at one vertex after the other. Its memory is reused.
class EdgeVisitor {
 public:
  EdgeVisitor(const RawMesh& mesh, const MeshTopology& topology) : mesh_(mesh), topology_(topology) {}

  /// Classifies v by its edges, and adds up those whose other end has a higher index.
  std::uint8_t visit(Index v, EdgeSums& sums) {
    ends_.clear();
    for (Index s = topology_.star_begin[v]; s < topology_.star_begin[v + 1]; ++s) {
      const Index corner = topology_.star[s];
      const auto& face = mesh_.face[corner / 3];
      ends_.push_back(face[next_in_face(corner) % 3]);
      ends_.push_back(face[previous_in_face(corner) % 3]);
    }
    higher_.clear();
    const std::uint8_t kind = ends_.size() <= few ? count_few(v) : count_sorted(v);
    if (!mesh_.counted_copies.empty() && mesh_.counted_copies[v] == 0) return kind;
    for (const Index end : higher_) sums.length += (mesh_.position[end] - mesh_.position[v]).norm();
    sums.edges += higher_.size();
    return kind;
  }

 private:
  static constexpr std::size_t few = 16;

  /// Counts the faces at each edge by comparing all ends with all: without branches, which are unpredictable here.
  std::uint8_t count_few(Index v) {
    const std::size_t n = ends_.size();
    ends_.resize(few, v);  // no end of an edge of v
    Index faces[few] = {};
    Index higher[few];
    std::size_t count = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Index end = ends_[k];
      higher[count] = end;
      count += ((faces[k] == 0) & (end > v)) ? 1 : 0;
      for (std::size_t i = 0; i < few; ++i) faces[i] += ends_[i] == end ? 1 : 0;
    }
    higher_.assign(higher, higher + count);
    std::uint8_t kind = 0;
    for (std::size_t k = 0; k < n; ++k) kind |= kind_of_edge(faces[k]);
    return kind;
  }

  std::uint8_t count_sorted(Index v) {
    std::sort(ends_.begin(), ends_.end());
    std::uint8_t kind = 0;
    for (std::size_t begin = 0, end = 0; begin < ends_.size(); begin = end) {
      while (end < ends_.size() && ends_[end] == ends_[begin]) ++end;
      kind |= kind_of_edge(end - begin);
      if (ends_[begin] > v) higher_.push_back(ends_[begin]);
    }
    return kind;
  }

  const RawMesh& mesh_;
  const MeshTopology& topology_;
  Array<Index> ends_;    ///< the other two vertices of each face
  Array<Index> higher_;  ///< ends of a higher index than v, each once
};

bool is_degenerate(const RawMesh& mesh, const std::array<Index, 3>& f) {
  if (has_repeated_vertex(f)) return true;
  const Vec3 a = mesh.position[f[1]] - mesh.position[f[0]];
  const Vec3 b = mesh.position[f[2]] - mesh.position[f[0]];
  return !has_area(a, b, a.cross(b));
}

}  // namespace

MeshTopology find_topology(const RawMesh& mesh, Job& job) {
  constexpr std::size_t grain = 8192;
  const std::size_t n = mesh.position.size();
  MeshTopology topology;
  find_stars(mesh, topology, job);
  job.report(0.6);

  Array<std::uint8_t> kind(n, 0);
  Array<EdgeSums> sums((n + grain - 1) / grain);  // one a chunk: added up in their order, whoever computed them
  job.parallel(n, grain, [&](Chunks& chunks) {
    EdgeVisitor edges(mesh, topology);
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        kind[v] = edges.visit(static_cast<Index>(v), sums[chunks.index()]);
  });
  EdgeSums all;
  for (const EdgeSums& s : sums) {
    all.length += s.length;
    all.edges += s.edges;
  }
  if (!(all.length > 0) && !mesh.whole) throw InvalidMesh("the mesh has no edge of any length");
  topology.edges = all.edges;
  if (all.edges > 0) topology.own_edge_length = all.length / static_cast<double>(all.edges);
  const bool is_known = mesh.whole && mesh.whole->average_edge_length > 0;
  topology.average_edge_length = is_known ? mesh.whole->average_edge_length : topology.own_edge_length;

  topology.border.resize(n);
  job.serial(n, [&](std::size_t v) {
    topology.border[v] = (kind[v] & on_border) != 0;
    if (topology.border[v]) topology.border_vertices += mesh.counted(v);
    if (kind[v] & non_manifold) topology.non_manifold_vertices += mesh.counted(v);
  });
  job.serial(mesh.face.size(), [&](std::size_t f) {
    if (mesh.counts_face(f)) topology.degenerate_faces += is_degenerate(mesh, mesh.face[f]);
  });
  return topology;
}

}  // namespace vcg_core::detail
