// SPDX-License-Identifier: GPL-3.0-or-later
#include "whole_medians.h"

#include <limits>
#include <utility>

#include "median.h"
#include "told_whole.h"

namespace vcg_core::detail {

namespace {

template <class Counts>
Array<double> only(const Array<double>& value, const Counts& counts) {
  Array<double> counted;
  counted.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i)
    if (counts(i)) counted.push_back(value[i]);
  return counted;
}

/// The medians that a piece is told; null: none.
const std::vector<double>* told_medians(const MeshArrays& mesh) {
  const GuidedWhole* const told = told_whole(mesh);
  return told != nullptr ? &told->medians : nullptr;
}

}  // namespace

double WholeMedians::of_faces(const Array<double>& value) {
  if (needs_no_values()) return next({}, 1);
  return next(mesh_.counted_face.empty() ? value : only(value, [&](std::size_t f) { return mesh_.counts_face(f); }), 1);
}

double WholeMedians::of_vertices(const Array<double>& length) {
  const double e = mesh_.topology.average_edge_length;
  if (needs_no_values()) return next({}, e);
  return next(mesh_.counted_copies.empty() ? length : only(length, [&](std::size_t v) { return mesh_.counted(v) > 0; }),
              e);
}

double WholeMedians::of_all(Array<double> value) { return next(std::move(value), 1); }

std::size_t WholeMedians::most_values(std::size_t usual) const {
  return counts_ == nullptr ? usual : std::numeric_limits<std::size_t>::max();
}

double WholeMedians::next(Array<double> value, double unit) {
  const std::size_t place = known_.size();
  if (counts_ != nullptr) {
    if (counts_->size() <= place) counts_->resize(place + 1);
    for (const double x : value) (*counts_)[place].add(x / unit);
  }
  const std::vector<double>* const told = told_medians(mesh_);
  if (told != nullptr && place < told->size()) {
    known_.push_back((*told)[place]);
    return known_.back() * unit;
  }
  const double measured = median(std::move(value));
  known_.push_back(measured / unit);
  return measured;
}

bool WholeMedians::needs_no_values() const {
  const std::vector<double>* const told = told_medians(mesh_);
  return counts_ == nullptr && told != nullptr && known_.size() < told->size();
}

}  // namespace vcg_core::detail
