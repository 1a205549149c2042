// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_builder.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace vcg_core::detail {

namespace {

constexpr std::size_t rows_between_polls = 16384;

}  // namespace

PatchBuilder::PatchBuilder(const LaneMesh& lanes, const LaneKernel& kernel)
    : lanes_(lanes),
      lane_count_(kernel.lanes),
      per_unit_(1 / lanes.mesh.topology.average_edge_length),
      order_(kernel.within_reach),
      row_of_(lanes.mesh.size()) {}

const Patch& PatchBuilder::build(std::size_t first, std::size_t last, double reach, const std::function<void()>& poll) {
  forget_last();
  first_group_ = first;
  last_group_ = last;
  reach_ = static_cast<float>(std::min(reach, 1e15));
  place_sources();
  collect_rows(poll);
  place_rows();
  reserve_kernel_memory();
  return patch_;
}

const PatchGroup& PatchBuilder::group(std::size_t g) {
  const Array<Index>& begin = lanes_.groups.begin;
  // The sources are the first rows, group by group.
  const std::uint32_t* const source_row = source_row_.data() + (begin[g] - begin[first_group_]);
  return order_.of(patch_, source_row, begin[g + 1] - begin[g], ball_[g - first_group_], reach_);
}

void PatchBuilder::forget_last() {
  row_of_.clear();
  rows_.clear();
}

void PatchBuilder::place_sources() {
  const Index begin = lanes_.groups.begin[first_group_];
  const Index end = lanes_.groups.begin[last_group_];
  const Array<Index>& member = lanes_.groups.member;
  middle_ = Vec3::Zero();
  for (Index s = begin; s < end; ++s) middle_ += lanes_.position[member[s]] / (end - begin);
  source_row_.clear();
  for (Index s = begin; s < end; ++s) {
    source_row_.push_back(static_cast<std::uint32_t>(rows_.size()));
    row_of_.set(member[s], source_row_.back());
    rows_.push_back(row_at(member[s]));
  }
  ball_.clear();
  last_near_ = 0;
  for (std::size_t g = first_group_; g < last_group_; ++g)
    ball_.push_back(ball_around(rows_.data() + (lanes_.groups.begin[g] - begin),
                                lanes_.groups.begin[g + 1] - lanes_.groups.begin[g]));
}

GroupBall PatchBuilder::ball_around(const Row* source, std::size_t count) const {
  GroupBall ball{};
  for (std::size_t s = 0; s < count; ++s)
    for (int axis = 0; axis < 3; ++axis) ball.middle[axis] += source[s].place[axis] / static_cast<float>(count);
  for (std::size_t s = 0; s < count; ++s) {
    const float x = source[s].place[0] - ball.middle[0];
    const float y = source[s].place[1] - ball.middle[1];
    const float z = source[s].place[2] - ball.middle[2];
    ball.radius = std::max(ball.radius, std::sqrt(x * x + y * y + z * z));
  }
  return ball;
}

/// The vertices that are connected to the sources inside the balls around their groups, and their faces.
void PatchBuilder::collect_rows(const std::function<void()>& poll) {
  const MeshTopology& topology = lanes_.mesh.topology;
  face_begin_.clear();
  patch_.has_hubs = false;
  std::uint32_t faces = 0;
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    if (poll && (row + 1) % rows_between_polls == 0) poll();
    face_begin_.push_back(faces);
    const Index begin = topology.star_begin[rows_[row].vertex];
    const Index end = topology.star_begin[rows_[row].vertex + 1];
    patch_.has_hubs = patch_.has_hubs || end - begin > most_face_bits;
    reserve_faces(faces + (end - begin));
    for (Index s = begin; s < end; ++s) {
      const RingFace face = lanes_.ring[s];
      if (row_of_[face.next] == unknown) consider(face.next);
      if (row_of_[face.previous] == unknown) consider(face.previous);
      place_face(faces++, row, face);
    }
  }
  face_begin_.push_back(faces);
  // The kernel shapes faces by whole vectors: those behind the last one are of the first row and not used.
  for (std::uint32_t f = faces; f < faces + lane_count_; ++f) apex_[f] = row_1_[f] = row_2_[f] = 0;
  patch_.face_begin = face_begin_.data();
  patch_.apex = apex_.data();
  patch_.row_1 = row_1_.data();
  patch_.row_2 = row_2_.data();
  patch_.marks = marks_.data();
}

void PatchBuilder::reserve_faces(std::size_t faces) {
  if (faces + lane_count_ <= apex_.size()) return;
  const std::size_t room = 2 * faces + lane_count_;
  apex_.resize(room);
  row_1_.resize(room);
  row_2_.resize(room);
  marks_.resize(room);
}

PatchBuilder::Row PatchBuilder::row_at(Index vertex) const {
  const Vec3 place = (lanes_.position[vertex] - middle_) * per_unit_;
  return {vertex, {static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2])}};
}

void PatchBuilder::consider(Index vertex) {
  const Row row = row_at(vertex);
  const auto within = [&](const GroupBall& ball) {
    const float x = row.place[0] - ball.middle[0];
    const float y = row.place[1] - ball.middle[1];
    const float z = row.place[2] - ball.middle[2];
    const float reach = ball.radius + reach_;
    return x * x + y * y + z * z <= reach * reach;
  };
  bool is_near = within(ball_[last_near_]);
  for (std::size_t g = 0; !is_near && g < ball_.size(); ++g) {
    is_near = within(ball_[g]);
    if (is_near) last_near_ = g;
  }
  if (is_near) {
    row_of_.set(vertex, static_cast<std::uint32_t>(rows_.size()));
    rows_.push_back(row);
  } else {
    row_of_.set(vertex, outside);
  }
}

void PatchBuilder::place_rows() {
  const std::size_t n = rows_.size();
  for (int axis = 0; axis < 3; ++axis) {
    place_[axis].resize(n);
    normal_[axis].resize(n);
    patch_.place[axis] = place_[axis].data();
    patch_.normal[axis] = normal_[axis].data();
  }
  for (std::size_t row = 0; row < n; ++row) {
    const Vec3& normal = lanes_.normal[rows_[row].vertex];
    for (int axis = 0; axis < 3; ++axis) {
      place_[axis][row] = rows_[row].place[axis];
      normal_[axis][row] = static_cast<float>(normal[axis]);
    }
  }
  patch_.rows = static_cast<std::uint32_t>(n);
}

void PatchBuilder::place_face(std::uint32_t f, std::uint32_t row, const RingFace& ring_face) {
  std::uint32_t row_1 = row_of_[ring_face.next];
  std::uint32_t row_2 = row_of_[ring_face.previous];
  // Of a hub's slot no bit is left.
  auto mark_1 = static_cast<std::uint32_t>(std::uint64_t(1) << ring_face.slot_at_next);
  auto mark_2 = static_cast<std::uint32_t>(std::uint64_t(1) << ring_face.slot_at_previous);
  if (row_1 == outside && row_2 == outside) {
    row_1 = row_2 = row;
    mark_1 = mark_2 = 0;
  } else if (row_1 == outside) {
    row_1 = row_2;
    mark_1 = mark_2;
  } else if (row_2 == outside) {
    row_2 = row_1;
    mark_2 = mark_1;
  }
  apex_[f] = row;
  row_1_[f] = row_1;
  row_2_[f] = row_2;
  marks_[f] = {mark_1, mark_2};
}

void PatchBuilder::reserve_kernel_memory() {
  constexpr std::size_t alignment = 64;
  const std::size_t bytes = rows_.size() * lane_count_ * sizeof(float);
  distance_.resize(rows_.size() * lane_count_ + alignment / sizeof(float));
  shape_.resize(face_begin_.back() + lane_count_);
  pending_.resize(rows_.size());
  void* aligned = distance_.data();
  std::size_t space = distance_.size() * sizeof(float);
  patch_.distance = static_cast<float*>(std::align(alignment, bytes, aligned, space));
  patch_.shape = shape_.data();
  patch_.pending = pending_.data();
}

}  // namespace vcg_core::detail
