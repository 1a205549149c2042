// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <vcg_core/parameter_info.h>

namespace vcg_core {

/// Whether the vertices of border edges (edges with one face) move. The paper is silent about borders.
enum class Boundary { fixed, free };

/// What every filter is told.
struct CommonParameters {
  int iterations = 1;
  Boundary boundary = Boundary::fixed;
  bool selected_only = false;
  bool check = false;
  int threads = 0;
};

/// The rows that filters share. All is SmoothingParameters, which is not complete here.
template <class All>
struct CommonRows {
  ParameterInfo iterations = {&All::iterations,
                              "iterations",
                              "Passes",
                              "How often the filter is applied. Higher: smoother, and edges get"
                              " rounder.",
                              at_least(1),
                              "the paper needs one, noise above 0.3 average edge lengths may want two"};
  ParameterInfo boundary = {&All::boundary, "boundary", "Border vertices",
                            "fixed: vertices of border edges (edges with one face) stay where they are; free: they are"
                            " smoothed like all others.",
                            one_of({"fixed", "free"})};
  ParameterInfo selected = {&All::selected_only, "selected", "Move selected vertices only",
                            "On: only selected vertices and the vertices of selected faces move; all others stay and"
                            " still serve as neighbours. The selection itself is never changed.",
                            on_with_selection()};
};

/// What is told to a run of whatever filter; not part of what it computes.
template <class All>
std::vector<ParameterInfo> run_parameters() {
  return {{&All::check, "check", "", "On: the faces of the result that cut through others are counted as well.",
           on_or_off()},
          {&All::threads, "threads", "", "Number of threads, 0 for one a processor; the result does not depend on it.",
           at_least(0, "one for each processor")}};
}

}  // namespace vcg_core
