// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "comparison.h"

namespace anisosmooth {

/// Per vertex: the mean over its faces of the angle in degrees between their normals at `a` and at `b`. Faces without
/// area are left out; vertices without others get 0.
std::vector<double> normal_errors(const mesh_tools::Mesh& mesh, const Positions& a, const Positions& b);

/// Per vertex: the mean over the methods of the error of the normals against the reference; without a reference,
/// against the mean of the methods' normals, which tells where they disagree.
std::vector<double> mean_normal_errors(const Comparison& comparison);

/// A patch of a surface.
struct Region {
  vcg::Point3d center;
  vcg::Point3d normal;  ///< unit length; mean over the patch
  double radius = 0;
};

/// Where `error` is strongest, on average over a patch about as large as `radius`.
Region strongest_region(const mesh_tools::Mesh& mesh, const Positions& positions, const std::vector<double>& error,
                        double radius);

}  // namespace anisosmooth
