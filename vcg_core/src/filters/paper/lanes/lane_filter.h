// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <vcg_core/filters/paper_parameters.h>

#include "filters/filter.h"
#include "patch.h"
#include "ring.h"
#include "source_groups.h"

namespace vcg_core::detail {

/// The paper's filter in single precision, for many vertices at once: the fast twin of paper_pass. Distances and
/// weights are computed in floats relative to the middle of a few groups of sources, the new position in double. Keeps
/// from pass to pass the groups of sources and the faces around each vertex.
class LanePass {
 public:
  explicit LanePass(const PaperParameters& parameters);  ///< with the fastest kernel
  LanePass(const PaperParameters& parameters, const LaneKernel& kernel);

  PassOutput run(const PassInput& in);

 private:
  struct Kept {
    Rings ring;
    SourceGroups groups;
    Array<Index> patch_begin;  ///< groups by patch
  };

  PaperParameters parameters_;
  const LaneKernel& kernel_;
  std::optional<Kept> kept_;
};

}  // namespace vcg_core::detail
