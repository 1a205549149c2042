#pragma once

#include "lane_vector3.h"

namespace vcg_core::detail {
namespace {

/// Stands for infinity: finite, so that no arithmetic with it gives a NaN.
constexpr float unreached = 1e15f;

/// Section 4.1 for a face in all lanes, as in virtual_start.h but with the frame's origin in the middle of the edge.
/// Holds the smallest distance around a vertex and the smallest squared distance from a virtual start point.
struct Nearest {
  Vector around = Simd::set(unreached);
  Vector squared = Simd::set(unreached * unreached);

  void look_at(const Patch& patch, std::uint32_t face) {
    const FaceShape& shape = patch.shape[face];
    const Vector d_1 = Simd::load(patch.distance + patch.row_1[face] * Simd::lanes);
    const Vector d_2 = Simd::load(patch.distance + patch.row_2[face] * Simd::lanes);
    const Vector sum = Simd::add(d_1, d_2);
    const Vector difference = Simd::sub(d_1, d_2);
    const Vector squared_edge = Simd::set(shape.squared_edge);
    const Vector half_inverse = Simd::set(shape.half_inverse);
    const Vector x_s = Simd::mul(Simd::mul(sum, difference), half_inverse);
    // h_s = sqrt((e^2 - t^2) (s^2 - e^2)) / (2 e): factored, as d_1^2 - x_s^2 loses all digits in single precision.
    const Vector product =
        Simd::mul(Simd::sub_mul(squared_edge, difference, difference), Simd::mul_sub(sum, sum, squared_edge));
    const Vector h_s = Simd::mul(Simd::sqrt(Simd::max(product, Simd::set(0))), half_inverse);
    const Vector height = Simd::add(h_s, Simd::set(shape.y));
    const Vector crossing = Simd::mul_add(x_s, Simd::set(shape.y), Simd::mul(Simd::set(shape.x), h_s));
    // Strictly: where all lies on one line, both sides are 0. Through an end of the edge, the way around it is the
    // same.
    const Mask between = Simd::less(Simd::abs(crossing), Simd::mul(Simd::set(shape.half_edge), height));
    const Vector dx = Simd::sub(Simd::set(shape.x), x_s);
    squared = Simd::min_where(between, squared, Simd::mul_add(dx, dx, Simd::mul(height, height)));
    around =
        Simd::min(around, Simd::min(Simd::add(d_1, Simd::set(shape.side_1)), Simd::add(d_2, Simd::set(shape.side_2))));
  }

  Vector distance() const { return Simd::min(around, Simd::sqrt(squared)); }
};

/// The march: rows are computed outwards, from the faces behind the front; at once these faces are looked at from their
/// two other vertices as well. When a row improves that the front has passed, the faces around it become pending at
/// their other vertices; rows with pending faces are computed again, the lowest first, a little behind the front:
/// label-correcting, with errors mended before they spread.
class March {
 public:
  March(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, LanePoll poll, void* context)
      : p_(patch),
        g_(group),
        limit_(Simd::set(parameters.limit)),
        tolerance_(Simd::set(parameters.tolerance)),
        poll_(poll),
        context_(context) {}

  void run() {
    start();
    settle_inner();
    sweep_outwards();
  }

 private:
  void start() {
    for (std::uint32_t rank = 0; rank < g_.rows; ++rank) {
      Simd::store(at(g_.row_at[rank]), Simd::set(unreached));
      p_.pending[g_.row_at[rank]] = 0;
    }
    for (std::uint32_t word = 0; word <= g_.rows / 64; ++word) g_.dirty[word] = 0;
    for (std::uint32_t lane = 0; lane < g_.sources; ++lane) at(g_.source_row[lane])[lane] = 0;
  }

  /// Among the sources no order suits all lanes: all rows there are swept up, down and up, which leaves little, and
  /// then those with pending faces until nothing improves.
  void settle_inner() {
    front_ = g_.inner_rows;
    for (std::uint32_t rank = 0; rank < g_.inner_rows; ++rank) lower(g_.row_at[rank], faces_behind(g_.row_at[rank]));
    for (std::uint32_t rank = g_.inner_rows; rank-- > 0;) lower(g_.row_at[rank], faces_behind(g_.row_at[rank]));
    for (std::uint32_t rank = 0; rank < g_.inner_rows; ++rank) renew(g_.row_at[rank], faces_behind(g_.row_at[rank]));
    while (any_inner_dirty()) {
      for (std::uint32_t rank = g_.inner_rows; rank-- > 0;)
        if (take_dirty(rank)) renew_pending(g_.row_at[rank]);
      for (std::uint32_t rank = 0; rank < g_.inner_rows; ++rank)
        if (take_dirty(rank)) renew_pending(g_.row_at[rank]);
    }
    lowest_dirty_ = g_.inner_rows;
  }

  bool any_inner_dirty() const {
    std::uint64_t any = 0;
    for (std::uint32_t word = 0; word <= g_.inner_rows / 64; ++word) any |= g_.dirty[word];
    return any != 0;
  }

  void sweep_outwards() {
    constexpr float lag = 0.3f;
    constexpr std::uint32_t stride = 4;
    std::uint32_t settled = 0;
    for (std::uint32_t rank = g_.inner_rows; rank < g_.rows; ++rank) {
      const std::uint32_t row = g_.row_at[rank];
      const std::uint32_t faces = faces_behind(row);
      lower(row, faces);
      front_ = rank + 1;
      look_back(row, faces);
      if (rank % stride != 0) continue;
      const float behind = __builtin_sqrtf(g_.squared_radius[rank]) - lag;
      while (settled < rank && g_.squared_radius[settled] < behind * behind) ++settled;
      clean_below(settled);
    }
    clean_below(g_.rows);
  }

  /// Whether the front has passed both other vertices of a face.
  bool is_behind(std::uint32_t f) const {
    return (g_.rank_of[p_.row_1[f]] < front_) & (g_.rank_of[p_.row_2[f]] < front_);
  }

  /// The bits of the faces of a row that are behind the front.
  std::uint32_t faces_behind(std::uint32_t row) const {
    const std::uint32_t begin = p_.face_begin[row];
    const std::uint32_t end = p_.face_begin[row + 1];
    std::uint32_t faces = 0;
    for (std::uint32_t f = begin; f < end; ++f) {
      const std::uint32_t slot = f - begin;
      faces |= static_cast<std::uint32_t>(is_behind(f)) << (slot < last_slot ? slot : last_slot);
    }
    return faces;
  }

  /// The faces by which the front has reached a row may also be a way to their other vertices, in some lanes.
  void look_back(std::uint32_t row, std::uint32_t faces) {
    const std::uint32_t begin = p_.face_begin[row];
    const Vector from = Simd::load(at(row));
    for (; faces != 0; faces &= faces - 1) {
      const std::uint32_t slot = static_cast<std::uint32_t>(__builtin_ctz(faces));
      if (slot == last_slot) return pass_on(row);
      const std::uint32_t f = begin + slot;
      const FaceShape& shape = p_.shape[f];
      const Vector d_1 = Simd::load(at(p_.row_1[f]));
      const Vector d_2 = Simd::load(at(p_.row_2[f]));
      const Vector side_1 = Simd::set(shape.side_1);
      const Vector side_2 = Simd::set(shape.side_2);
      const Vector edge = Simd::set(shape.edge);
      if (may_improve(d_1, from, side_1, d_2, edge, side_2)) renew(p_.row_1[f], p_.marks[f].of_row_1);
      if (may_improve(d_2, from, side_2, d_1, edge, side_1)) renew(p_.row_2[f], p_.marks[f].of_row_2);
    }
  }

  /// Whether a face may lower the distance of its apex from d, by a bound that takes no root. With the virtual start
  /// point S the face is a convex quadrilateral: its diagonals, the edge and the way from S to the apex, are together
  /// longer than two opposite sides. So that way is longer than both d_a + side_b - edge and d_b + side_a - edge.
  bool may_improve(Vector d, Vector d_a, Vector side_a, Vector d_b, Vector side_b, Vector edge) const {
    const Vector around = Simd::min(Simd::add(d_a, side_a), Simd::add(d_b, side_b));
    const Vector across = Simd::sub(Simd::max(Simd::add(d_a, side_b), Simd::add(d_b, side_a)), edge);
    return Simd::any(Simd::less(Simd::min(around, across), enough(d)));
  }

  /// Below this a distance is worth passing on.
  Vector enough(Vector before) const { return Simd::sub(Simd::min(before, limit_), tolerance_); }

  /// Computes dirty rows of ranks below `end`, always the lowest one next, until there are none.
  void clean_below(std::uint32_t end) {
    while (true) {
      const std::uint32_t rank = next_dirty(end);
      if (rank >= end) break;
      lowest_dirty_ = rank;
      take_dirty(rank);
      renew_pending(g_.row_at[rank]);
    }
    if (lowest_dirty_ < end) lowest_dirty_ = end;
  }

  std::uint32_t next_dirty(std::uint32_t end) const {
    if (lowest_dirty_ >= end) return end;
    std::uint32_t word = lowest_dirty_ / 64;
    std::uint64_t bits = g_.dirty[word] & (~std::uint64_t(0) << (lowest_dirty_ % 64));
    while (bits == 0) {
      if (++word > (end - 1) / 64) return end;
      bits = g_.dirty[word];
    }
    return word * 64 + static_cast<std::uint32_t>(__builtin_ctzll(bits));
  }

  void renew_pending(std::uint32_t row) {
    const std::uint32_t faces = p_.pending[row];
    p_.pending[row] = 0;
    renew(row, faces);
  }

  /// Lowers the distances of a row by some of its faces and passes that on, if a lane within the limit gains enough.
  /// Most rows do not: squares are compared, and the root is taken of the others only.
  void renew(std::uint32_t row, std::uint32_t faces) {
    const Nearest nearest = look_at(row, faces);
    const Vector before = Simd::load(at(row));
    const Vector squared = Simd::min(nearest.squared, Simd::mul(nearest.around, nearest.around));
    // At a source, distance 0, nothing is an improvement, and no square is smaller than 0.
    const Vector positive = Simd::max(enough(before), Simd::set(0));
    if (!Simd::any(Simd::less(squared, Simd::mul(positive, positive)))) return;
    Simd::store(at(row), Simd::min(before, nearest.distance()));
    pass_on(row);
  }

  /// Lowers the distances of a row by some of its faces.
  void lower(std::uint32_t row, std::uint32_t faces) {
    Simd::store(at(row), Simd::min(Simd::load(at(row)), look_at(row, faces).distance()));
  }

  Nearest look_at(std::uint32_t row, std::uint32_t faces) {
    if (++visits_ % 4096 == 0) poll_(context_);
    const std::uint32_t begin = p_.face_begin[row];
    Nearest nearest;
    for (; faces != 0; faces &= faces - 1) {
      const std::uint32_t slot = static_cast<std::uint32_t>(__builtin_ctz(faces));
      if (slot == last_slot) {
        look_at_rest(row, nearest);
        break;
      }
      nearest.look_at(p_, begin + slot);
    }
    return nearest;
  }

  /// All faces that the last bit stands for.
  void look_at_rest(std::uint32_t row, Nearest& nearest) const {
    for (std::uint32_t f = p_.face_begin[row] + last_slot; f < p_.face_begin[row + 1]; ++f)
      if (is_behind(f)) nearest.look_at(p_, f);
  }

  /// Makes the faces around a row pending at their two other vertices, where the front has passed both.
  void pass_on(std::uint32_t row) {
    for (std::uint32_t f = p_.face_begin[row]; f < p_.face_begin[row + 1]; ++f) {
      const std::uint32_t row_1 = p_.row_1[f];
      const std::uint32_t row_2 = p_.row_2[f];
      const std::uint32_t rank_1 = g_.rank_of[row_1];
      const std::uint32_t rank_2 = g_.rank_of[row_2];
      if (rank_1 >= front_ || rank_2 >= front_) continue;
      p_.pending[row_1] |= p_.marks[f].of_row_1;
      p_.pending[row_2] |= p_.marks[f].of_row_2;
      make_dirty(rank_1);
      make_dirty(rank_2);
      const std::uint32_t lowest = rank_1 < rank_2 ? rank_1 : rank_2;
      if (lowest < lowest_dirty_) lowest_dirty_ = lowest;
    }
  }

  void make_dirty(std::uint32_t rank) { g_.dirty[rank / 64] |= std::uint64_t(1) << (rank % 64); }

  bool take_dirty(std::uint32_t rank) {
    const std::uint64_t bit = std::uint64_t(1) << (rank % 64);
    const bool was = (g_.dirty[rank / 64] & bit) != 0;
    g_.dirty[rank / 64] &= ~bit;
    return was;
  }

  float* at(std::uint32_t row) const { return p_.distance + row * Simd::lanes; }

  const Patch& p_;
  const PatchGroup& g_;
  Vector limit_;
  Vector tolerance_;
  LanePoll poll_;
  void* context_;
  std::uint32_t front_ = 0;         ///< ranks below have been reached
  std::uint32_t lowest_dirty_ = 0;  ///< no rank below is dirty
  std::uint32_t visits_ = 0;
};

void lane_march(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, LanePoll poll,
                void* context) {
  March(patch, group, parameters, poll, context).run();
}

}  // namespace
}  // namespace vcg_core::detail
