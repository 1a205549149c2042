// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic_march.h"

#include <limits>

#include "triangle_frames.h"

namespace vcg_core::detail {

template <class Scalar, class Frames>
GeodesicMarch<Scalar, Frames>::GeodesicMarch(const MeshArrays& mesh, const Frames& frames, Scalar tolerance)
    : mesh_(mesh),
      frames_(frames),
      tolerance_(tolerance),
      distance_(mesh.size(), std::numeric_limits<Scalar>::infinity()),
      state_(mesh.size(), State::unseen) {}

template <class Scalar, class Frames>
void GeodesicMarch<Scalar, Frames>::clear() {
  for (const Index v : reached_) {
    distance_[v] = std::numeric_limits<Scalar>::infinity();
    state_[v] = State::unseen;
  }
  reached_.clear();
  front_ = {};
}

template <class Scalar, class Frames>
void GeodesicMarch<Scalar, Frames>::run(Index source, Scalar limit, const std::function<void(std::size_t)>& poll) {
  constexpr std::size_t pops_between_polls = 4096;
  clear();
  offer(source, 0);
  std::size_t pops = 0;
  std::size_t settled = 0;
  while (!front_.empty() && front_.top().first < limit) {
    const Index v = front_.top().second;
    front_.pop();
    if (state_[v] != State::open) continue;  // settled since by an entry of a smaller distance
    settle(v);
    ++settled;
    if (++pops % pops_between_polls == 0) poll(settled);
  }
}

template <class Scalar, class Frames>
void GeodesicMarch<Scalar, Frames>::offer(Index v, Scalar distance) {
  if (!(distance < distance_[v])) return;
  const Scalar gain = distance_[v] - distance;
  distance_[v] = distance;
  if (state_[v] == State::settled && !(gain > tolerance_)) return;
  if (state_[v] == State::unseen) reached_.push_back(v);
  state_[v] = State::open;
  front_.emplace(distance, v);
}

template <class Scalar, class Frames>
void GeodesicMarch<Scalar, Frames>::settle(Index v) {
  state_[v] = State::settled;
  const MeshTopology& topology = mesh_.topology;
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Index corner = topology.star[s];
    const Index next = next_in_face(corner);
    const Index previous = previous_in_face(corner);
    const Index a = vertex_of(mesh_, next);
    const Index b = vertex_of(mesh_, previous);
    offer(a, distance_[v] + frames_[corner].side_1);
    offer(b, distance_[v] + frames_[corner].side_2);
    // Of each frame the first of the two known vertices is the one that follows the apex in the face.
    if (state_[a] == State::settled) offer(b, distance_by_virtual_start(frames_[previous], distance_[v], distance_[a]));
    if (state_[b] == State::settled) offer(a, distance_by_virtual_start(frames_[next], distance_[b], distance_[v]));
  }
}

template class GeodesicMarch<double>;
template class GeodesicMarch<long double, FramesOnDemand>;

}  // namespace vcg_core::detail
