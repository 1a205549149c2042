// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <support/flat_mesh.h>
#include <vcg_core/smoothing_parameters.h>

namespace test_support {

/// What the paper's formulas say about one vertex.
struct NaiveVertex {
  Point position;                         ///< v_i - n_i d_i, or v_i if it is not to move
  std::vector<std::size_t> neighborhood;  ///< N(v_i), ascending
  double clearance = 0;                   ///< least difference between a distance and the cut-off, in |e|
};

/// The paper's filter straight from its formulas (section 4.2's N(v_i), section 6's d_i) and from the decisions where
/// the paper is silent: no lists, no order, no arrays shared with the library. Each vertex costs sweeps over the whole
/// mesh. Vertices at the same place are one: the first of them, which alone is in neighbourhoods. One pass.
class NaiveReference {
 public:
  /// @param reach  as in naive_geodesics, in |e|
  /// @param e      |e|, if it is not to be this mesh's own
  explicit NaiveReference(const FlatMesh& mesh, double reach = std::numeric_limits<double>::infinity());
  NaiveReference(const FlatMesh& mesh, double reach, double e);

  const Point& normal(std::size_t i) const { return normal_[first_[i]]; }
  double average_edge_length() const { return e_; }
  bool on_border(std::size_t i) const { return border_[first_[i]]; }

  /// Section 4.1's distances from v_i, in the mesh's unit.
  std::vector<double> distances(std::size_t i) const;

  /// `parameters.selected_only`, `iterations` and `threads` are not looked at.
  NaiveVertex smooth(std::size_t i, const vcg_core::SmoothingParameters& parameters) const;

 private:
  FlatMesh mesh_;                   ///< welded
  std::vector<std::size_t> first_;  ///< of the vertices in the place of each
  double e_;
  double reach_;
  std::vector<Point> normal_;  ///< of unit length, or zero where undefined
  std::vector<bool> border_;
};

/// `passes` passes of the reference over the whole mesh. All lengths stay multiples of the given mesh's |e|.
FlatMesh naive_smooth(FlatMesh mesh, const vcg_core::SmoothingParameters& parameters, int passes);

}  // namespace test_support
