// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lane_nearest.h"
#include "lowest_bit.h"

namespace vcg_core::detail {
namespace {

/// What both ways of marching share: the matrix of distances, rows times lanes, what a face does to it, and the count
/// of the work.
class MarchState {
 public:
  MarchState(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, LanePoll poll,
             void* context)
      : p_(patch),
        g_(group),
        limit_(Simd::set(parameters.limit)),
        tolerance_(Simd::set(parameters.tolerance)),
        poll_(poll),
        context_(context) {
    for (std::uint32_t rank = 0; rank < group.rows; ++rank) {
      Simd::store(at(group.row_at[rank]), Simd::set(unreached));
      patch.pending[group.row_at[rank]] = 0;
    }
    for (std::uint32_t lane = 0; lane < group.sources; ++lane) at(group.source_row[lane])[lane] = 0;
  }

 protected:
  float* at(std::uint32_t row) const { return p_.distance + std::size_t(row) * Simd::lanes; }

  /// Below this a distance is worth passing on.
  Vector enough(Vector before) const {
    return Simd::mul_sub(Simd::min(before, limit_), Simd::set(1 - rounding), tolerance_);
  }

  /// What some faces of a row, no hub, make of its distances.
  Nearest look_at(std::uint32_t row, std::uint32_t faces) {
    const std::uint32_t begin = p_.face_begin[row];
    std::uint32_t looks = 0;
    Nearest nearest;
    for (; faces != 0; faces &= faces - 1) {
      ++looks;
      const std::uint32_t f = begin + lowest_bit(faces);
      nearest.look_at(Simd::load(at(p_.row_1[f])), Simd::load(at(p_.row_2[f])), in_all_lanes(p_.shape[f]));
    }
    count_looks(looks);
    return nearest;
  }

  /// Lowers the distances of a row by some of its faces, if a lane within the limit gains enough. Most rows do not:
  /// squares are compared, and the root is taken of the others only. What decides in the end is what would be stored: a
  /// square may be smaller than another while their roots round to the same number.
  /// @param gained  if so, the new distances of the lanes that gain enough, and `unreached` in the others
  bool improve(std::uint32_t row, std::uint32_t faces, Vector& gained) {
    const Nearest nearest = look_at(row, faces);
    const Vector before = Simd::load(at(row));
    const Vector squared = Simd::min(nearest.squared, Simd::mul(nearest.around, nearest.around));
    // At a source, distance 0, nothing is an improvement, and no square is smaller than 0.
    const Vector positive = Simd::max(enough(before), Simd::set(0));
    if (!Simd::any(Simd::less(squared, Simd::mul(positive, positive)))) return false;
    return store(row, before, nearest.distance(), gained);
  }

  /// Stores distances if a lane gains enough; see `improve`.
  bool store(std::uint32_t row, Vector before, Vector distance, Vector& gained) {
    const Gain gain{distance, Simd::less(distance, enough(before))};
    if (!gain.any()) return false;
    gained = gain.in_lanes();
    Simd::store(at(row), Simd::min(before, distance));
    return true;
  }

  /// What a face may bring one of its vertices, by a bound.
  struct Gain {
    Vector distance;  ///< no lane comes out lower
    Mask enough;      ///< lanes in which that would be worth passing on
    bool any() const { return Simd::any(enough); }
    Vector in_lanes() const { return Simd::select(enough, distance, Simd::set(unreached)); }
  };
  struct Gains {
    Gain of_row_1, of_row_2;
  };

  /// What a face, at whose apex the distance is `from`, may bring its two other vertices.
  Gains gains(std::uint32_t f, Vector from) const {
    const FaceShape& shape = p_.shape[f];
    const Vector d_1 = Simd::load(at(p_.row_1[f]));
    const Vector d_2 = Simd::load(at(p_.row_2[f]));
    const Vector side_1 = Simd::set(shape.side_1);
    const Vector side_2 = Simd::set(shape.side_2);
    const Vector edge = Simd::set(shape.edge);
    return {gain(d_1, from, side_1, d_2, edge, side_2), gain(d_2, from, side_2, d_1, edge, side_1)};
  }

  /// What a face may bring a vertex at the distance d, by a bound that takes no root. With the virtual start point S
  /// the face is a convex quadrilateral: its diagonals, the edge and the line from S to the apex, are together longer
  /// than two opposite sides. So that line is longer than both d_a + side_b - edge and d_b + side_a - edge.
  Gain gain(Vector d, Vector d_a, Vector side_a, Vector d_b, Vector side_b, Vector edge) const {
    const Vector around = Simd::min(Simd::add(d_a, side_a), Simd::add(d_b, side_b));
    const Vector across = Simd::sub(Simd::max(Simd::add(d_a, side_b), Simd::add(d_b, side_a)), edge);
    const Vector bound = Simd::min(around, across);
    return {bound, Simd::less(bound, enough(d))};
  }

  void double_tolerance() { tolerance_ = Simd::add(tolerance_, tolerance_); }

  void count_looks(std::uint32_t looks) {
    const std::uint64_t before = looks_;
    looks_ += looks;
    if (before / looks_between_polls != looks_ / looks_between_polls) poll_(context_);
  }

  static constexpr std::uint64_t looks_between_polls = 4096;

  const Patch& p_;
  const PatchGroup& g_;
  std::uint64_t looks_ = 0;

 private:
  Vector limit_;
  Vector tolerance_;
  LanePoll poll_;
  void* context_;
};

}  // namespace
}  // namespace vcg_core::detail
