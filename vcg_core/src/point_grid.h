// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "mesh_arrays.h"

namespace vcg_core::detail {

/// Finds the points within one fixed Euclidean distance of a place, whatever the connectivity: a uniform grid with
/// cells as wide as that distance, of which only the occupied ones are kept, sorted. Cells stay that small however far
/// apart points lie, up to 2^42 cells.
class PointGrid {
 public:
  /// @param points  indices into `position` of the points to find
  /// @param radius  > 0, in units of `position`
  /// @param job     polled, if there is one
  PointGrid(const Array<Vec3>& position, const Array<Index>& points, double radius, Job* job = nullptr);

  /// One thread's searches. Places near the one before cost less: the cells around it are remembered.
  class Search {
   public:
    explicit Search(const PointGrid& grid) : grid_(grid) {}

    /// Calls visit(index, position) for each point less than the radius away from `center`, in an order that depends
    /// on the points and on the cell of `center` only.
    template <class Visit>
    void for_each_near(const Vec3& center, Visit&& visit) {
      find_rows(grid_.cell_of(center));
      for (const auto& row : rows_) {
        looks_ += row.second - row.first;
        for (std::size_t k = row.first; k < row.second; ++k)
          if ((grid_.position_[k] - center).squaredNorm() < grid_.squared_radius_)
            visit(grid_.index_[k], grid_.position_[k]);
      }
    }

    /// How many points were looked at so far, near or not.
    std::size_t looks() const { return looks_; }

   private:
    void find_rows(const std::array<std::int64_t, 3>& cell);

    const PointGrid& grid_;
    std::size_t looks_ = 0;
    std::array<std::int64_t, 3> cell_{-1, -1, -1};
    std::array<std::pair<std::size_t, std::size_t>, 9> rows_;  ///< ranges of points: three cells along x each
  };

 private:
  /// The occupied layers of cells across one axis, ascending, and what they are numbered by in keys: neighbours have
  /// neighbouring numbers, and empty layers between others share one.
  struct Layers {
    Array<std::int64_t> cell;
    Array<std::int64_t> number;
  };

  std::array<std::int64_t, 3> cell_of(const Vec3& p) const;
  void number_layers(int axis, const Array<Vec3>& position);
  std::int64_t number_of(int axis, std::int64_t cell) const;
  std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z) const;

  double squared_radius_;
  double cell_size_;
  std::int64_t last_cell_;  ///< along each axis
  std::array<Layers, 3> layers_;
  std::int64_t last_number_;  ///< along each axis
  int bits_per_axis_;
  Vec3 origin_;
  Array<std::uint64_t> key_;  ///< the cell of each point, ascending; neighbours along x are consecutive
  Array<Index> index_;
  Array<Vec3> position_;
};

}  // namespace vcg_core::detail
