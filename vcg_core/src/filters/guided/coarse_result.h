// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "face_geometry.h"
#include "face_lists.h"
#include "guided_settings.h"
#include "mesh_arrays.h"
#include "noise_estimate.h"
#include "whole_medians.h"

namespace vcg_core::detail {

/// What the guided filter has when its coarse rounds are done.
struct CoarseResult {
  const MeshArrays& mesh;
  const GuidedSettings& settings;
  const Array<std::uint8_t>& movable;
  const Array<Vec3>& noisy;  ///< positions
  const NoiseEstimate& noise;
  WholeMedians& medians;  ///< the next one is that of the residuals
  FaceLists within;
  Array<double> spacing;
  Array<Vec3> position;  ///< after the coarse rounds
  FaceGeometry faces;    ///< there
};

}  // namespace vcg_core::detail
