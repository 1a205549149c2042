// SPDX-License-Identifier: GPL-3.0-or-later
#include "source_groups.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "job.h"

namespace vcg_core::detail {

namespace {

/// Grows groups over a block of the mesh's vertices, each time by the vertex on the rim that lies nearest to the
/// group's middle: compact groups have neighbourhoods that overlap most.
class Grouper {
 public:
  Grouper(const MeshArrays& mesh, std::uint32_t lanes, Index block_begin, Index block_end)
      : mesh_(mesh), lanes_(lanes), block_begin_(block_begin), block_end_(block_end), state_(block_end - block_begin) {
    for (Index v = block_begin; v < block_end; ++v) {
      const bool has_faces = mesh.topology.star_begin[v] != mesh.topology.star_begin[v + 1];
      state(v) = has_faces ? State::left : State::taken;
    }
  }

  SourceGroups run() {
    groups_.begin.push_back(0);
    for (Index seed = block_begin_; seed < block_end_; ++seed) {
      if (state(seed) != State::left) continue;
      sum_ = Vec3::Zero();
      grow_from(seed);
      fill_up(seed);
      groups_.begin.push_back(static_cast<Index>(groups_.member.size()));
    }
    return std::move(groups_);
  }

 private:
  enum class State : std::uint8_t { taken, left, on_rim };

  std::size_t group_size() const { return groups_.member.size() - groups_.begin.back(); }
  State& state(Index v) { return state_[v - block_begin_]; }
  bool in_block(Index v) const { return v >= block_begin_ && v < block_end_; }
  bool full() const { return group_size() == lanes_; }

  void grow_from(Index first) {
    rim_.clear();
    take(first);
    while (!full() && !rim_.empty()) {
      const Vec3 middle = sum_ / static_cast<double>(group_size());
      const auto distance = [&](Index v) { return (mesh_.position[v] - middle).squaredNorm(); };
      const auto nearest =
          std::min_element(rim_.begin(), rim_.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
      const Index v = *nearest;
      *nearest = rim_.back();
      rim_.pop_back();
      take(v);
    }
    for (const Index v : rim_) state(v) = State::left;
  }

  /// A group that is walled in by others takes in what is left near by, in the mesh's order.
  void fill_up(Index seed) {
    constexpr double hops_apart = 4;   // twice the radius of a full group: farther sources share few neighbours
    constexpr Index look_ahead = 256;  // vertices; as the order is along a curve, later ones are rarely near
    const double apart = hops_apart * mesh_.topology.average_edge_length;
    for (Index v = seed + 1; v < block_end_ && v - seed < look_ahead && !full(); ++v)
      if (state(v) == State::left && (mesh_.position[v] - mesh_.position[seed]).norm() < apart) grow_from(v);
  }

  void take(Index v) {
    state(v) = State::taken;
    groups_.member.push_back(v);
    sum_ += mesh_.position[v];
    const MeshTopology& topology = mesh_.topology;
    for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
      const Index other = vertex_of(mesh_, next_in_face(topology.star[s]));
      if (!in_block(other) || state(other) != State::left) continue;
      state(other) = State::on_rim;
      rim_.push_back(other);
    }
  }

  const MeshArrays& mesh_;
  std::uint32_t lanes_;
  Index block_begin_;
  Index block_end_;
  std::vector<State> state_;
  SourceGroups groups_;
  Vec3 sum_ = Vec3::Zero();
  Array<Index> rim_;
};

}  // namespace

SourceGroups group_sources(const MeshArrays& mesh, std::uint32_t lanes, Job& job) {
  // Fixed, so that the groups do not depend on the number of threads; large, as groups at its rim are not full.
  constexpr std::size_t block = 16384;
  std::vector<SourceGroups> of_block((mesh.size() + block - 1) / block);
  job.parallel(mesh.size(), block, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      of_block[chunks.index()] =
          Grouper(mesh, lanes, static_cast<Index>(chunks.begin()), static_cast<Index>(chunks.end())).run();
  });
  SourceGroups all;
  all.begin.push_back(0);
  for (const SourceGroups& groups : of_block) {
    job.poll();
    const auto before = static_cast<Index>(all.member.size());
    all.member.insert(all.member.end(), groups.member.begin(), groups.member.end());
    for (std::size_t g = 1; g < groups.begin.size(); ++g) all.begin.push_back(before + groups.begin[g]);
  }
  return all;
}

Array<Index> patch_groups(const SourceGroups& groups, const MeshArrays& mesh) {
  constexpr Index most_groups = 16;    // more hardly lower the share of the building, and the patch leaves the cache
  constexpr double far_in_edges = 16;  // places stay within some tens of |e|, and floats exact to 4e-6 |e|
  const double apart = far_in_edges * mesh.topology.average_edge_length;
  const auto place = [&](Index g) { return mesh.position[groups.member[groups.begin[g]]]; };
  Array<Index> begin;
  for (Index g = 0; g < groups.size(); ++g)
    if (begin.empty() || g - begin.back() == most_groups || (place(g) - place(begin.back())).norm() > apart)
      begin.push_back(g);
  begin.push_back(static_cast<Index>(groups.size()));
  return begin;
}

}  // namespace vcg_core::detail
