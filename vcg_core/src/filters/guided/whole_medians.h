// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <vcg_core/mesh/value_counts.h>
#include "mesh_arrays.h"

namespace vcg_core::detail {

/// The medians over the whole mesh that a run goes by, one after the other: measured, over the faces or vertices that
/// count; or, in a piece of a larger mesh, those that it is told (GuidedWhole::medians), whatever the values are.
class WholeMedians {
 public:
  /// @param mesh    referred to
  /// @param counts  those of the values that each median is over are added here, one after the other; null: nowhere
  explicit WholeMedians(const MeshArrays& mesh, std::vector<ValueCounts>* counts = nullptr)
      : mesh_(mesh), counts_(counts) {}

  /// The next median, of values by face.
  double of_faces(const Array<double>& value);
  /// Of values by vertex, lengths.
  double of_vertices(const Array<double>& length);
  /// Of values that all count.
  double of_all(Array<double> value);

  /// Of so many values a median is found, evenly taken, where there are more.
  std::size_t most_values(std::size_t usual) const;

  /// Those until now; lengths in |e|.
  const std::vector<double>& known() const { return known_; }

 private:
  double next(Array<double> value, double unit);
  /// Whether the next median can be had without its values.
  bool needs_no_values() const;

  const MeshArrays& mesh_;
  std::vector<ValueCounts>* counts_;
  std::vector<double> known_;
};

}  // namespace vcg_core::detail
