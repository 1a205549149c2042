#include "mesh_topology.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

#include <vcg_core/detail/job.h>
#include <vcg_core/errors.h>

#include "face_area.h"

namespace vcg_core::detail {

namespace {

bool has_repeated_vertex(const std::array<Index, 3>& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

void find_stars(const RawMesh& mesh, MeshTopology& topology) {
  topology.star_begin.assign(mesh.position.size() + 2, 0);
  // Counts go two places up: the fill below moves each offset to its final place as it goes.
  Index* const count = topology.star_begin.data() + 2;
  for (const auto& face : mesh.face) {
    if (has_repeated_vertex(face)) continue;
    for (const Index v : face) ++count[v];
  }
  std::partial_sum(topology.star_begin.begin(), topology.star_begin.end(), topology.star_begin.begin());
  topology.star.resize(3 * mesh.face.size());
  Index* const end_of = topology.star_begin.data() + 1;
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    if (has_repeated_vertex(mesh.face[f])) continue;
    for (Index k = 0; k < 3; ++k) topology.star[end_of[mesh.face[f][k]]++] = static_cast<Index>(3 * f + k);
  }
  topology.star_begin.pop_back();
  topology.star.resize(topology.star_begin.back());
}

enum VertexKind : std::uint8_t { on_border = 1, non_manifold = 2 };

struct EdgeSums {
  double length = 0;
  std::size_t edges = 0;
};

/// Classifies v by its edges, and adds up those whose other end has a higher index.
void visit_edges(const RawMesh& mesh, const MeshTopology& topology, Index v, Array<Index>& ends, EdgeSums& sums,
                 std::uint8_t& kind) {
  ends.clear();
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Index corner = topology.star[s];
    const auto& face = mesh.face[corner / 3];
    ends.push_back(face[next_in_face(corner) % 3]);
    ends.push_back(face[previous_in_face(corner) % 3]);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && ends[end] == ends[begin]) ++end;
    const std::size_t faces = end - begin;
    if (faces == 1) kind |= on_border;
    if (faces > 2) kind |= non_manifold;
    if (ends[begin] < v) continue;  // counted at its other end
    sums.length += (mesh.position[ends[begin]] - mesh.position[v]).norm();
    ++sums.edges;
  }
}

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
  find_stars(mesh, topology);
  job.report(0.6);

  Array<std::uint8_t> kind(n, 0);
  Array<EdgeSums> sums((n + grain - 1) / grain);  // one a chunk: added up in their order, whoever computed them
  job.parallel(n, grain, [&](Chunks& chunks) {
    Array<Index> ends;
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        visit_edges(mesh, topology, static_cast<Index>(v), ends, sums[chunks.index()], kind[v]);
  });
  EdgeSums all;
  for (const EdgeSums& s : sums) {
    all.length += s.length;
    all.edges += s.edges;
  }
  if (!(all.length > 0)) throw InvalidMesh("the mesh has no edge of any length");
  topology.average_edge_length = all.length / static_cast<double>(all.edges);

  topology.border.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    topology.border[v] = (kind[v] & on_border) != 0;
    topology.border_vertices += topology.border[v];
    topology.non_manifold_vertices += (kind[v] & non_manifold) != 0;
  }
  for (const auto& face : mesh.face) topology.degenerate_faces += is_degenerate(mesh, face);
  return topology;
}

}  // namespace vcg_core::detail
