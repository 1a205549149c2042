// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vcg_core/method.h>

#include "mesh_arrays.h"

namespace vcg_core::detail {

class Job;
struct VertexAttributes;

/// What one pass of a smoothing filter gets.
struct PassInput {
  const MeshArrays& mesh;              ///< the mesh as it was read
  const Array<Vec3>& position;         ///< where its vertices are now, in units of MeshArrays::position
  const Array<Vec3>& normal;           ///< their unit normals, zero where undefined; empty if not asked for
  const Array<std::uint8_t>& movable;  ///< whether each vertex may move; never one without faces
  Job& job;                            ///< its stage is begun; for threads and progress
};

/// What it gives back.
struct PassOutput {
  Array<Vec3> position;                  ///< the new positions; unchanged where a vertex does not move
  std::size_t empty_neighbourhoods = 0;  ///< movable vertices (copies) that had nothing to be smoothed by
  /// Movable vertices (copies) whose distances were cut short, as they would have cost out of all proportion: a
  /// distance may be too large, and a neighbour near the cut-off missing.
  std::size_t approximate_neighbourhoods = 0;
  Array<std::uint8_t> bounded = {};            ///< whether each vertex was held back; empty: none was
  std::vector<std::string> notes = {};         ///< sentences for the user, as SmoothingReport has it
  std::optional<double> estimated_noise = {};  ///< standard deviation, in units of MeshArrays::position
};

/// One pass. An object, as a filter may keep from pass to pass what depends on the connectivity only.
using FilterPass = std::function<PassOutput(const PassInput&)>;

/// A fresh pass that keeps nothing but the filter's own part of the parameters.
template <class Own>
FilterPass bind_pass(PassOutput (*pass)(const PassInput&, const Own&), const SmoothingParameters& all) {
  const Own& own = all;
  return [pass, own](const PassInput& in) { return pass(in, own); };
}

/// Smooths colour and quality on the smoothed surface.
/// @param position  the smoothed one
using AttributeSmoother = void (*)(const MeshArrays& mesh, const Array<Vec3>& position,
                                   const Array<std::uint8_t>& movable, const SmoothingParameters& parameters,
                                   VertexAttributes& attributes, Job& job);

/// A method and the code behind it: what each folder of filters contributes to the catalogue.
struct Filter {
  MethodInfo info;
  const char* advice;  ///< as SmoothingReport has it
  bool needs_normals;  ///< whether PassInput::normal is wanted; vertices without a normal then stay in place
  std::function<FilterPass(const SmoothingParameters&)> make_pass;  ///< a fresh pass for a run over one mesh
  bool one_pass = false;                                            ///< whether `iterations` is the filter's own affair
  AttributeSmoother smooth_attributes = nullptr;                    ///< for `smooth_color`, if the filter has it
};

}  // namespace vcg_core::detail
