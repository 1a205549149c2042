// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tiles {

using Point = std::array<double, 3>;

/// The smallest box around points.
struct Box {
  Point min, max;

  Box();  ///< around none
  void extend(const Point& p);
};

/// Cubes side by side over a box, numbered along x, then y, then z.
class Grid {
 public:
  Grid() = default;
  /// @param along  how many cubes along the longest side of the box; they are at most 2^24 altogether
  Grid(const Box& box, std::uint32_t along);
  Grid(const Point& origin, double side, const std::array<std::uint32_t, 3>& size)
      : origin_(origin), side_(side), size_(size) {}

  const Point& origin() const { return origin_; }
  double side() const { return side_; }
  const std::array<std::uint32_t, 3>& size() const { return size_; }
  std::size_t cells() const { return std::size_t{size_[0]} * size_[1] * size_[2]; }

  /// Along each axis; points outside the box are taken for points on it.
  std::array<std::uint32_t, 3> place_of(const Point& p) const { return {along(p, 0), along(p, 1), along(p, 2)}; }
  std::uint32_t cell_at(const std::array<std::uint32_t, 3>& place) const {
    return (place[2] * size_[1] + place[1]) * size_[0] + place[0];
  }
  std::uint32_t cell_of(const Point& p) const { return cell_at(place_of(p)); }
  std::array<std::uint32_t, 3> place_of_cell(std::uint32_t cell) const {
    return {cell % size_[0], cell / size_[0] % size_[1], cell / size_[0] / size_[1]};
  }

 private:
  std::uint32_t along(const Point& p, std::size_t axis) const {
    const double place = (p[axis] - origin_[axis]) / side_;
    if (!(place > 0)) return 0;
    return place < size_[axis] - 1 ? static_cast<std::uint32_t>(place) : size_[axis] - 1;
  }

  Point origin_{};
  double side_ = 1;
  std::array<std::uint32_t, 3> size_{1, 1, 1};
};

}  // namespace tiles
