// SPDX-License-Identifier: GPL-3.0-or-later
#include "result_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "job.h"
#include "power_of_two.h"

#include "face_area.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 8192;

/// Whether a face's normal points to the other side than before. Without an area on either side it has no normal.
bool is_flipped(const std::array<Index, 3>& f, const Array<Vec3>& before, const Array<Vec3>& after) {
  const Vec3 a = before[f[1]] - before[f[0]], b = before[f[2]] - before[f[0]];
  const Vec3 c = after[f[1]] - after[f[0]], d = after[f[2]] - after[f[0]];
  const Vec3 old_normal = a.cross(b), new_normal = c.cross(d);
  return old_normal.dot(new_normal) < 0 && has_area(a, b, old_normal) && has_area(c, d, new_normal);
}

/// What one chunk of vertices or faces adds to the report.
struct Counts {
  std::size_t flipped = 0;
  std::size_t far_moved = 0;
  std::size_t beyond_ring = 0;
  bool opposed = false;  ///< two faces along an edge look to opposite sides
  double largest_coordinate = 0;
};

class VertexCheck {
 public:
  VertexCheck(const MeshArrays& mesh, const Array<Vec3>& position) : mesh_(mesh), position_(position) {}

  void visit(Index v, Counts& counts) {
    const MeshTopology& topology = mesh_.topology;
    const Index begin = topology.star_begin[v], end = topology.star_begin[v + 1];
    if (begin == end || mesh_.counted(v) == 0) return;
    counts.largest_coordinate = std::max(counts.largest_coordinate, mesh_.position[v].cwiseAbs().maxCoeff());
    const double step = (position_[v] - mesh_.position[v]).squaredNorm();
    const double limit = 2 * topology.average_edge_length;
    if (step > limit * limit) counts.far_moved += mesh_.counted(v);
    if (step > 0 && is_beyond_ring(v, step)) counts.beyond_ring += mesh_.counted(v);
    if (!topology.border_vertices && !topology.non_manifold_vertices)
      counts.opposed = counts.opposed || has_repeated_successor(begin, end);
  }

 private:
  bool is_beyond_ring(Index v, double squared_step) const {
    const auto shorter = [&](Index end) {
      return (mesh_.position[end] - mesh_.position[v]).squaredNorm() < squared_step;
    };
    for (Index s = mesh_.topology.star_begin[v]; s < mesh_.topology.star_begin[v + 1]; ++s) {
      const Index corner = mesh_.topology.star[s];
      if (!shorter(vertex_of(mesh_, next_in_face(corner))) || !shorter(vertex_of(mesh_, previous_in_face(corner))))
        return false;
    }
    return true;
  }

  /// Around a vertex whose edges have two faces each, faces that look to the same side all go on to different vertices.
  bool has_repeated_successor(Index begin, Index end) {
    next_.clear();
    for (Index s = begin; s < end; ++s) next_.push_back(vertex_of(mesh_, next_in_face(mesh_.topology.star[s])));
    if (next_.size() > few) {
      std::sort(next_.begin(), next_.end());
      return std::adjacent_find(next_.begin(), next_.end()) != next_.end();
    }
    unsigned repeated = 0;  // all with all, without branches
    for (std::size_t i = 1; i < next_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) repeated |= static_cast<unsigned>(next_[i] == next_[k]);
    return repeated != 0;
  }

  static constexpr std::size_t few = 12;
  const MeshArrays& mesh_;
  const Array<Vec3>& position_;
  std::vector<Index> next_;
};

}  // namespace

void round_as_stored(const MeshArrays& mesh, Array<Vec3>& position, Job& job) {
  if (mesh.coordinate_epsilon != static_cast<double>(std::numeric_limits<float>::epsilon())) return;
  const PowerOfTwo to_host(-mesh.exponent);
  const PowerOfTwo from_host(mesh.exponent);
  job.parallel(position.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        for (double& x : position[v]) {
          // At the caller's scale, where small numbers may have fewer digits. Volatile: GCC 12.2 leaves out the
          // rounding at the end of the loop that it makes of this.
          const volatile auto stored = static_cast<float>(to_host * x);
          x = from_host * static_cast<double>(stored);
        }
        if (!position[v].allFinite()) position[v] = mesh.position[v];  // as commit_positions() does
      }
  });
}

void check_result(const MeshArrays& mesh, const Array<Vec3>& position, SmoothingReport& report, Job& job) {
  const auto chunks_of = [](std::size_t count) { return (count + grain - 1) / grain; };
  Array<Counts> counts(std::max(chunks_of(mesh.size()), chunks_of(mesh.face.size())));
  job.parallel(mesh.face.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f)
        if (mesh.counts_face(f)) counts[chunks.index()].flipped += is_flipped(mesh.face[f], mesh.position, position);
  });
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    VertexCheck check(mesh, position);
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        check.visit(static_cast<Index>(v), counts[chunks.index()]);
  });
  Counts all;
  for (const Counts& part : counts) {
    all.flipped += part.flipped;
    all.far_moved += part.far_moved;
    all.beyond_ring += part.beyond_ring;
    all.opposed = all.opposed || part.opposed;
    all.largest_coordinate = std::max(all.largest_coordinate, part.largest_coordinate);
  }
  report.faces = mesh.counted_faces();
  report.flipped_faces = all.flipped;
  report.far_moved_vertices = all.far_moved;
  report.beyond_ring_vertices = all.beyond_ring;
  report.closed = !mesh.topology.border_vertices && !mesh.topology.non_manifold_vertices && !all.opposed;
  if (all.largest_coordinate > 0)
    report.coordinate_spacing = std::ldexp(mesh.coordinate_epsilon, std::ilogb(all.largest_coordinate) - mesh.exponent);
}

}  // namespace vcg_core::detail
