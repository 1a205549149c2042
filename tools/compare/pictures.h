// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparison.h"

namespace anisosmooth {

struct View {
  vcg::Point3d direction{-0.8, -1.3, 1.5};  ///< from the object to the camera
  vcg::Point3d up{0, 0, 1};
};

struct Pictures {
  std::vector<std::string> files;  ///< names in the folder
  std::string problem;             ///< one sentence if there are none
};

/// Draws the noisy mesh and all results with f3d under a virtual display and joins the pictures with ImageMagick:
/// figure9.png, flat shaded, the second row with the region of strongest error enlarged; errors.png, coloured by the
/// error of the normals (with a reference) or by the displacement from the noisy mesh, with its scale.
/// @throws vcg_core::Cancelled when the user interrupts; nothing of the work is left then
Pictures draw_pictures(const Comparison& comparison, const View& view, const std::filesystem::path& folder);

}  // namespace anisosmooth
