// SPDX-License-Identifier: GPL-3.0-or-later
#include "moved_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "text_splicer.h"

namespace mesh_tools::io {
namespace {

using vcg::Point3d;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Keys that are in order and equal as the coordinates' bits are, so that numbers that are none do no harm.
std::array<std::uint64_t, 3> key_of(const Point3d& p) {
  std::array<std::uint64_t, 3> key{};
  for (int k = 0; k < 3; ++k) {
    const double value = p[k] + 0.0;  // -0 and 0 are the same place
    std::memcpy(&key[k], &value, sizeof value);
  }
  return key;
}

/// For each point the index of a point that is equal, the same one for all that are.
std::vector<std::uint32_t> equal_ones(const std::vector<Point3d>& points) {
  std::vector<std::uint32_t> order(points.size()), equal(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key_of(points[a]) < key_of(points[b]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_next = i > 0 && key_of(points[order[i]]) == key_of(points[order[i - 1]]);
    equal[order[i]] = is_next ? equal[order[i - 1]] : order[i];
  }
  return equal;
}

/// Zero if the vector has no direction.
Point3d unit(const Point3d& vector) {
  const double length = vector.Norm();
  return length > 0 && std::isfinite(length) ? vector / length : Point3d(0, 0, 0);
}

template <class VertexAt>
Point3d newell_normal(std::size_t corners, const VertexAt& at) {
  Point3d sum(0, 0, 0);
  const Point3d first = at(0);
  for (std::size_t k = 2; k < corners; ++k) sum += (at(k - 1) - first) ^ (at(k) - first);
  return unit(sum);
}

}  // namespace

void MovedVertices::add(const Point3d& before_place, const Point3d& now) {
  bool is_same = true;
  for (int k = 0; k < 3; ++k) is_same &= is_same_number(before_place[k], now[k]);
  before.push_back(before_place);
  moved.push_back(!is_same);
}

MovedNormals::MovedNormals(const FlatMesh& mesh, const MovedVertices& vertices, const std::vector<Point3d>& normals)
    : mesh_(mesh),
      vertices_(vertices),
      place_(equal_ones(vertices.before)),
      value_(equal_ones(normals)),
      first_piece_(normals.size(), none) {}

std::uint32_t MovedNormals::piece_of(const Corner& corner) {
  const std::uint32_t place = place_[corner.vertex], value = value_[corner.normal];
  std::uint32_t& first = first_piece_[corner.normal];
  if (first != none && pieces_[first].place == place && pieces_[first].value == value) return first;
  const auto [entry, is_new] = piece_at_.try_emplace(static_cast<std::uint64_t>(place) << 32 | value,
                                                     static_cast<std::uint32_t>(pieces_.size()));
  if (is_new) pieces_.push_back({place, value});
  if (first == none)
    first = entry->second;
  else
    others_.emplace_back(corner.normal, entry->second);
  return entry->second;
}

void MovedNormals::add_face(const std::vector<Corner>& corners) {
  const std::size_t count = corners.size();
  const auto at = [&](std::size_t k) { return mesh_.position[corners[k % count].vertex]; };
  const Point3d normal = newell_normal(count, at);
  const bool moved =
      std::any_of(corners.begin(), corners.end(), [&](const Corner& corner) { return vertices_.moved[corner.vertex]; });
  for (std::size_t k = 0; k < count; ++k) {
    const Point3d next = at(k + 1) - at(k), last = at(k + count - 1) - at(k), across = next ^ last;
    double angle = std::atan2(across.Norm(), next * last);
    if (across * normal < 0) angle = 2 * M_PI - angle;  // a polygon's corner that points inwards
    Piece& piece = pieces_[piece_of(corners[k])];
    piece.moved |= moved;
    if (std::isfinite(angle)) piece.sum += normal * angle;
  }
}

void MovedNormals::add_triangles() {
  std::vector<Corner> corners(3);
  for (const auto& face : mesh_.face) {
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {face[k], face[k]};
    add_face(corners);
  }
}

void MovedNormals::finish() {
  std::sort(others_.begin(), others_.end());
  others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
}

std::optional<Point3d> MovedNormals::normal(std::size_t index) const {
  const std::uint32_t first = first_piece_[index];
  if (first == none) return std::nullopt;
  bool moved = pieces_[first].moved;
  Point3d sum = pieces_[first].sum;
  const auto number = static_cast<std::uint32_t>(index);
  for (auto other = std::lower_bound(others_.begin(), others_.end(), std::pair(number, std::uint32_t{0}));
       other != others_.end() && other->first == number; ++other) {
    moved |= pieces_[other->second].moved;
    sum += pieces_[other->second].sum;
  }
  constexpr double cancelled = 1e-12;  // faces that are opposite to each other leave rounding errors, no direction
  if (!moved || !(sum.Norm() > cancelled)) return std::nullopt;
  return unit(sum);
}

Point3d polygon_normal(const FlatMesh& mesh, const std::vector<std::uint32_t>& vertices) {
  return newell_normal(vertices.size(), [&](std::size_t k) { return mesh.position[vertices[k]]; });
}

}  // namespace mesh_tools::io
