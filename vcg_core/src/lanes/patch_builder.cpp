#include "patch_builder.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace vcg_core::detail {

PatchBuilder::PatchBuilder(const LaneMesh& lanes, std::uint32_t lane_count)
    : lanes_(lanes),
      lane_count_(lane_count),
      per_unit_(1 / lanes.mesh.topology.average_edge_length),
      row_of_(lanes.mesh.size(), unknown) {}

const Patch& PatchBuilder::build(const Index* sources, std::uint32_t count, double reach) {
  forget_last();
  collect_rows(sources, count, reach);
  sort_rows();
  patch_.rows = static_cast<std::uint32_t>(rows_.size());
  patch_.sources = count;
  patch_.source_row = source_row_;
  patch_.inner_rows = 0;
  for (std::uint32_t lane = 0; lane < count; ++lane) {
    source_row_[lane] = row_of_[sources[lane]];
    patch_.inner_rows = std::max(patch_.inner_rows, source_row_[lane] + 1);
  }
  place_rows();
  place_faces();
  reserve_kernel_memory();
  return patch_;
}

void PatchBuilder::forget_last() {
  for (const Row& row : rows_) row_of_[row.vertex] = unknown;
  for (const Index v : found_outside_) row_of_[v] = unknown;
  found_.clear();
  found_outside_.clear();
}

/// The vertices that are connected to the sources inside the balls around them.
void PatchBuilder::collect_rows(const Index* sources, std::uint32_t count, double reach) {
  squared_reach_ = static_cast<float>(std::min(reach * reach, 1e30));
  place_sources(sources, count);
  const MeshTopology& topology = lanes_.mesh.topology;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const Index v = found_[i].vertex;
    for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
      const RingFace& face = lanes_.ring[s];
      if (row_of_[face.next] == unknown) consider(face.next);
      if (row_of_[face.previous] == unknown) consider(face.previous);
    }
  }
}

void PatchBuilder::place_sources(const Index* sources, std::uint32_t count) {
  middle_ = Vec3::Zero();
  for (std::uint32_t lane = 0; lane < count; ++lane) middle_ += lanes_.position[sources[lane]] / count;
  for (std::uint32_t lane = 0; lane < most_lanes; ++lane) {
    const Row source = row_at(sources[lane < count ? lane : 0]);
    for (int axis = 0; axis < 3; ++axis) source_place_[axis][lane] = source.place[axis];
    if (lane >= count) continue;
    row_of_[source.vertex] = 0;
    found_.push_back(source);
  }
}

PatchBuilder::Row PatchBuilder::row_at(Index vertex) const {
  const Vec3 place = (lanes_.position[vertex] - middle_) * per_unit_;
  return {vertex,
          {static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2])},
          static_cast<float>(place.squaredNorm())};
}

void PatchBuilder::consider(Index vertex) {
  const Row row = row_at(vertex);
  int near = 0;
  for (std::uint32_t lane = 0; lane < most_lanes; ++lane) {
    const float x = row.place[0] - source_place_[0][lane];
    const float y = row.place[1] - source_place_[1][lane];
    const float z = row.place[2] - source_place_[2][lane];
    near |= x * x + y * y + z * z <= squared_reach_;
  }
  row_of_[vertex] = near != 0 ? 0 : outside;
  if (near != 0)
    found_.push_back(row);
  else
    found_outside_.push_back(vertex);
}

/// By radius: in buckets of equal area, and as they were found inside them.
void PatchBuilder::sort_rows() {
  constexpr float buckets_per_squared_edge = 4;
  constexpr float most_buckets = 8192;
  float largest = 0;
  for (const Row& row : found_) largest = std::max(largest, row.squared_radius);
  const float scale =
      largest * buckets_per_squared_edge < most_buckets ? buckets_per_squared_edge : most_buckets / largest;
  const auto bucket = [scale](const Row& row) { return static_cast<std::size_t>(row.squared_radius * scale); };
  bucket_begin_.assign(static_cast<std::size_t>(largest * scale) + 2, 0);
  for (const Row& row : found_) ++bucket_begin_[bucket(row) + 1];
  std::partial_sum(bucket_begin_.begin(), bucket_begin_.end(), bucket_begin_.begin());
  rows_.resize(found_.size());
  for (const Row& row : found_) {
    const std::uint32_t to = bucket_begin_[bucket(row)]++;
    rows_[to] = row;
    row_of_[row.vertex] = to;
  }
}

void PatchBuilder::place_rows() {
  const std::size_t n = rows_.size();
  squared_radius_.resize(n);
  for (int axis = 0; axis < 3; ++axis) {
    place_[axis].resize(n);
    normal_[axis].resize(n);
    patch_.place[axis] = place_[axis].data();
    patch_.normal[axis] = normal_[axis].data();
  }
  patch_.squared_radius = squared_radius_.data();
  for (std::size_t row = 0; row < n; ++row) {
    squared_radius_[row] = rows_[row].squared_radius;
    const Vec3& normal = lanes_.normal[rows_[row].vertex];
    for (int axis = 0; axis < 3; ++axis) {
      place_[axis][row] = rows_[row].place[axis];
      normal_[axis][row] = static_cast<float>(normal[axis]);
    }
  }
}

void PatchBuilder::place_faces() {
  const MeshTopology& topology = lanes_.mesh.topology;
  const auto n = static_cast<std::uint32_t>(rows_.size());
  face_begin_.resize(n + 1);
  ready_faces_.assign(n, 0);
  std::uint32_t faces = 0;
  for (std::uint32_t row = 0; row < n; ++row) {
    face_begin_[row] = faces;
    faces += topology.star_begin[rows_[row].vertex + 1] - topology.star_begin[rows_[row].vertex];
  }
  face_begin_[n] = faces;
  // The kernel shapes faces by whole vectors: those behind the last one are of the first row and not used.
  apex_.assign(faces + lane_count_, 0);
  row_1_.assign(faces + lane_count_, 0);
  row_2_.assign(faces + lane_count_, 0);
  marks_.resize(faces);
  for (std::uint32_t row = 0; row < n; ++row) {
    const Index begin = topology.star_begin[rows_[row].vertex];
    for (std::uint32_t slot = 0; slot < face_begin_[row + 1] - face_begin_[row]; ++slot)
      add_face(row, slot, lanes_.ring[begin + slot]);
  }
  patch_.face_begin = face_begin_.data();
  patch_.ready_faces = ready_faces_.data();
  patch_.apex = apex_.data();
  patch_.row_1 = row_1_.data();
  patch_.row_2 = row_2_.data();
  patch_.marks = marks_.data();
}

void PatchBuilder::add_face(std::uint32_t row, std::uint32_t slot, const RingFace& ring_face) {
  std::uint32_t row_1 = row_of_[ring_face.next];
  std::uint32_t row_2 = row_of_[ring_face.previous];
  std::uint32_t mark_1 = 1u << ring_face.slot_at_next;
  std::uint32_t mark_2 = 1u << ring_face.slot_at_previous;
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
  const std::uint32_t f = face_begin_[row] + slot;
  apex_[f] = row;
  row_1_[f] = row_1;
  row_2_[f] = row_2;
  marks_[f] = {mark_1, mark_2};
  const std::uint32_t front = row < patch_.inner_rows ? patch_.inner_rows : row;
  const std::uint32_t ready = std::max(row_1, row_2) < front;
  ready_faces_[row] |= ready << std::min<std::uint32_t>(slot, last_slot);
}

void PatchBuilder::reserve_kernel_memory() {
  constexpr std::size_t alignment = 64;
  const std::size_t bytes = rows_.size() * lane_count_ * sizeof(float);
  distance_.resize(rows_.size() * lane_count_ + alignment / sizeof(float));
  shape_.resize(apex_.size());
  pending_.resize(rows_.size());
  dirty_.resize(rows_.size() / 64 + 1);
  void* aligned = distance_.data();
  std::size_t space = distance_.size() * sizeof(float);
  patch_.distance = static_cast<float*>(std::align(alignment, bytes, aligned, space));
  patch_.shape = shape_.data();
  patch_.pending = pending_.data();
  patch_.dirty = dirty_.data();
}

}  // namespace vcg_core::detail
