#pragma once

#include "patch.h"

// The kernel that runs the paper's filter for a group of sources at once, one a lane. Included once by each of the
// files lane_kernel_*.cpp, after the Simd of their processor; no standard library here, as its inline functions would
// be compiled for that processor and might be linked into code that runs on all.

namespace vcg_core::detail {
namespace {

using Vector = Simd::Vector;
using Mask = Simd::Mask;

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
    // All of them: rows that are far from this group may be far from the front, and still be asked for.
    for (std::uint32_t row = 0; row < p_.rows; ++row) Simd::store(at(row), Simd::set(unreached));
    for (std::uint32_t row = 0; row < p_.rows; ++row) p_.pending[row] = 0;
    for (std::uint32_t word = 0; word <= g_.rows / 64; ++word) g_.dirty[word] = 0;
    for (std::uint32_t lane = 0; lane < g_.sources; ++lane) at(g_.source_row[lane])[lane] = 0;
  }

  /// Among the sources no order suits all lanes: the rows there are swept up and down until nothing improves.
  void settle_inner() {
    front_ = g_.inner_rows;
    for (std::uint32_t lane = 0; lane < g_.sources; ++lane) pass_on(g_.source_row[lane]);
    while (any_inner_dirty()) {
      for (std::uint32_t rank = g_.inner_rows; rank-- > 0;)
        if (take_dirty(rank)) renew(g_.row_at[rank]);
      for (std::uint32_t rank = 0; rank < g_.inner_rows; ++rank)
        if (take_dirty(rank)) renew(g_.row_at[rank]);
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
      const std::uint32_t faces = faces_behind(row, rank);
      front_ = rank + 1;
      improve(row, faces);
      check_back(row, faces);
      if (rank % stride != 0) continue;
      const float behind = __builtin_sqrtf(g_.squared_radius[rank]) - lag;
      while (settled < rank && g_.squared_radius[settled] < behind * behind) ++settled;
      clean_below(settled);
    }
    clean_below(g_.rows);
  }

  /// The bits of the faces of a row of which the two other vertices come before `rank`.
  std::uint32_t faces_behind(std::uint32_t row, std::uint32_t rank) const {
    const std::uint32_t begin = p_.face_begin[row];
    const std::uint32_t end = p_.face_begin[row + 1];
    std::uint32_t faces = 0;
    for (std::uint32_t f = begin; f < end; ++f) {
      const bool behind = (g_.rank_of[p_.row_1[f]] < rank) & (g_.rank_of[p_.row_2[f]] < rank);
      const std::uint32_t slot = f - begin;
      faces |= static_cast<std::uint32_t>(behind) << (slot < last_slot ? slot : last_slot);
    }
    return faces;
  }

  /// The faces by which the front has reached a row may also be a way to their other vertices, in some lanes.
  void check_back(std::uint32_t row, std::uint32_t faces) {
    const std::uint32_t begin = p_.face_begin[row];
    for (; faces != 0; faces &= faces - 1) {
      const std::uint32_t slot = static_cast<std::uint32_t>(__builtin_ctz(faces));
      if (slot == last_slot) return pass_on(row);
      check(p_.row_1[begin + slot], p_.marks[begin + slot].of_row_1);
      check(p_.row_2[begin + slot], p_.marks[begin + slot].of_row_2);
    }
  }

  /// Renews a row if one of its faces improves it. Few do: squares are compared, and the root is taken of those only.
  void check(std::uint32_t row, std::uint32_t mark) {
    const std::uint32_t slot = static_cast<std::uint32_t>(__builtin_ctz(mark));
    if (slot != last_slot) {
      Nearest nearest;
      nearest.look_at(p_, p_.face_begin[row] + slot);
      const Vector enough = Simd::sub(Simd::min(Simd::load(at(row)), limit_), tolerance_);
      const Vector squared = Simd::min(nearest.squared, Simd::mul(nearest.around, nearest.around));
      // At a source, distance 0, nothing is an improvement, and no square is smaller than 0.
      const Vector positive = Simd::max(enough, Simd::set(0));
      if (!Simd::any(Simd::less(squared, Simd::mul(positive, positive)))) return;
    }
    if (improve(row, mark)) pass_on(row);
  }

  /// Computes dirty rows of ranks below `end`, always the lowest one next, until there are none.
  void clean_below(std::uint32_t end) {
    while (true) {
      const std::uint32_t rank = next_dirty(end);
      if (rank >= end) break;
      lowest_dirty_ = rank;
      take_dirty(rank);
      renew(g_.row_at[rank]);
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

  void renew(std::uint32_t row) {
    const std::uint32_t faces = p_.pending[row];
    p_.pending[row] = 0;
    if (improve(row, faces)) pass_on(row);
  }

  /// Lowers the distances of a row by some of its faces; true if a lane gained enough, within the limit, to pass it on.
  bool improve(std::uint32_t row, std::uint32_t faces) {
    if (++visits_ % 4096 == 0) poll_(context_);
    const std::uint32_t begin = p_.face_begin[row];
    Nearest nearest;
    for (; faces != 0; faces &= faces - 1) {
      const std::uint32_t slot = static_cast<std::uint32_t>(__builtin_ctz(faces));
      nearest.look_at(p_, begin + slot);
      if (slot == last_slot)
        for (std::uint32_t f = begin + last_slot + 1; f < p_.face_begin[row + 1]; ++f) nearest.look_at(p_, f);
    }
    const Vector before = Simd::load(at(row));
    const Vector after = Simd::min(before, Simd::min(nearest.around, Simd::sqrt(nearest.squared)));
    Simd::store(at(row), after);
    return Simd::any(Simd::both(Simd::less(after, Simd::sub(before, tolerance_)), Simd::less(after, limit_)));
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
      const std::uint32_t lower = rank_1 < rank_2 ? rank_1 : rank_2;
      if (lower < lowest_dirty_) lowest_dirty_ = lower;
    }
  }

  float* at(std::uint32_t row) const { return p_.distance + row * Simd::lanes; }
  void make_dirty(std::uint32_t rank) { g_.dirty[rank / 64] |= std::uint64_t(1) << (rank % 64); }
  bool take_dirty(std::uint32_t rank) {
    const std::uint64_t bit = std::uint64_t(1) << (rank % 64);
    const bool was = (g_.dirty[rank / 64] & bit) != 0;
    g_.dirty[rank / 64] &= ~bit;
    return was;
  }

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

struct Vector3 {
  Vector x, y, z;
};

Vector3 difference(const Vector3& a, const Vector3& b) {
  return {Simd::sub(a.x, b.x), Simd::sub(a.y, b.y), Simd::sub(a.z, b.z)};
}

Vector dot(const Vector3& a, const Vector3& b) {
  return Simd::mul_add(a.x, b.x, Simd::mul_add(a.y, b.y, Simd::mul(a.z, b.z)));
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {Simd::mul_sub(a.y, b.z, Simd::mul(a.z, b.y)), Simd::mul_sub(a.z, b.x, Simd::mul(a.x, b.z)),
          Simd::mul_sub(a.x, b.y, Simd::mul(a.y, b.x))};
}

Vector3 gather_places(const Patch& patch, const std::uint32_t* row) {
  return {Simd::gather(patch.place[0], row), Simd::gather(patch.place[1], row), Simd::gather(patch.place[2], row)};
}

/// Shapes of the `lanes` faces from `first` on.
void shape_faces(const Patch& patch, std::uint32_t first) {
  const Vector3 v_1 = gather_places(patch, patch.row_1 + first);
  const Vector3 v_2 = gather_places(patch, patch.row_2 + first);
  const Vector3 apex = gather_places(patch, patch.apex + first);
  const Vector3 along = difference(v_2, v_1);
  const Vector3 to_apex = difference(apex, v_1);
  const Vector squared_edge = dot(along, along);
  const Vector edge = Simd::sqrt(squared_edge);
  const Vector half_edge = Simd::mul(edge, Simd::set(0.5f));
  const Vector zero = Simd::set(0);
  const Vector one = Simd::set(1);
  const Mask has_edge = Simd::less(Simd::set(1e-14f), edge);
  const Vector inverse = Simd::zero_unless(has_edge, Simd::div(one, Simd::max(edge, Simd::set(1e-14f))));
  const Vector3 normal = cross(along, to_apex);
  const Vector3 from_2 = difference(apex, v_2);
  const Vector columns[] = {
      Simd::select(has_edge, half_edge, Simd::sub(zero, one)),
      Simd::mul(inverse, Simd::set(0.5f)),
      squared_edge,
      Simd::mul_sub(dot(to_apex, along), inverse, half_edge),
      Simd::select(has_edge, Simd::mul(Simd::sqrt(dot(normal, normal)), inverse), one),
      Simd::sqrt(dot(to_apex, to_apex)),
      Simd::sqrt(dot(from_2, from_2)),
  };
  alignas(64) float column[7][Simd::lanes];
  for (int k = 0; k < 7; ++k) Simd::store(column[k], columns[k]);
  for (unsigned lane = 0; lane < Simd::lanes; ++lane)
    patch.shape[first + lane] = {column[0][lane], column[1][lane], column[2][lane], column[3][lane],
                                 column[4][lane], column[5][lane], column[6][lane], 0};
}

/// 2^-x for x >= 0, within 2e-7 of its value; what underflows gives about 1e-38.
Vector exp2_of_minus(Vector x) {
  const Vector y = Simd::sub(Simd::set(0), Simd::min(x, Simd::set(126)));
  const Vector whole = Simd::round(y);
  const Vector f = Simd::sub(y, whole);  // in [-1/2, 1/2]
  // Taylor's polynomial of 2^f: the coefficients are ln(2)^k / k!.
  Vector power = Simd::set(1.5403530e-4f);
  power = Simd::mul_add(power, f, Simd::set(1.3333558e-3f));
  power = Simd::mul_add(power, f, Simd::set(9.6181291e-3f));
  power = Simd::mul_add(power, f, Simd::set(5.5504109e-2f));
  power = Simd::mul_add(power, f, Simd::set(2.4022651e-1f));
  power = Simd::mul_add(power, f, Simd::set(6.9314718e-1f));
  power = Simd::mul_add(power, f, Simd::set(1.0f));
  return Simd::scale(power, whole);
}

/// One row's vector in all lanes.
Vector3 at_row(const float* const columns[3], std::uint32_t row) {
  return {Simd::set(columns[0][row]), Simd::set(columns[1][row]), Simd::set(columns[2][row])};
}

/// Section 6's sums for all lanes: rows are the neighbours v_j, lanes the vertices v_i.
void lane_offsets(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, float* offset) {
  alignas(64) float place[3][Simd::lanes] = {};
  alignas(64) float normal[3][Simd::lanes] = {};
  for (std::uint32_t lane = 0; lane < group.sources; ++lane)
    for (int axis = 0; axis < 3; ++axis) {
      place[axis][lane] = patch.place[axis][group.source_row[lane]];
      normal[axis][lane] = patch.normal[axis][group.source_row[lane]];
    }
  const Vector3 v_i{Simd::load(place[0]), Simd::load(place[1]), Simd::load(place[2])};
  const Vector3 n_i{Simd::load(normal[0]), Simd::load(normal[1]), Simd::load(normal[2])};
  const Vector cutoff = Simd::set(parameters.cutoff);
  const Vector closeness = Simd::set(parameters.closeness);
  const Vector similarity = Simd::set(parameters.similarity);
  const Vector normals = Simd::set(parameters.normals);
  Vector sum = Simd::set(0);
  Vector sum_of_weights = Simd::set(0);
  for (std::uint32_t rank = 0; rank < group.rows; ++rank) {
    const std::uint32_t row = group.row_at[rank];
    const Mask inside = Simd::less(Simd::load(patch.distance + row * Simd::lanes), cutoff);
    if (!Simd::any(inside)) continue;
    if (patch.normal[0][row] == 0 && patch.normal[1][row] == 0 && patch.normal[2][row] == 0) continue;
    const Vector3 v_j = at_row(patch.place, row);
    const Vector3 n_j = at_row(patch.normal, row);
    const Vector3 from_j = difference(v_i, v_j);
    const Vector height = dot(n_j, from_j);
    const Vector s = Simd::mul(height, similarity);
    const Vector n = Simd::mul(Simd::sub(Simd::set(1), dot(n_i, n_j)), normals);
    const Vector exponent = Simd::mul_add(dot(from_j, from_j), closeness, Simd::mul_add(s, s, Simd::mul(n, n)));
    const Vector weight = Simd::zero_unless(inside, exp2_of_minus(exponent));
    sum = Simd::mul_add(weight, height, sum);
    sum_of_weights = Simd::add(sum_of_weights, weight);
  }
  alignas(64) float result[Simd::lanes];
  Simd::store(result, Simd::div(sum, Simd::max(sum_of_weights, Simd::set(1e-30f))));
  for (std::uint32_t lane = 0; lane < group.sources; ++lane) offset[lane] = result[lane];
}

void lane_shape(const Patch& patch, LanePoll poll, void* context) {
  // Rounded up to whole vectors: the builder leaves room behind the last face.
  for (std::uint32_t f = 0; f < patch.face_begin[patch.rows]; f += Simd::lanes) {
    if (f % 65536 == 0) poll(context);
    shape_faces(patch, f);
  }
}

void lane_march(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters, LanePoll poll,
                void* context) {
  March(patch, group, parameters, poll, context).run();
}

}  // namespace
}  // namespace vcg_core::detail
