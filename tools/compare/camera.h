// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <vcg/space/point3.h>

namespace anisosmooth {

/// Where a picture is taken from. The view angle is narrow, so that distances hardly change sizes.
struct Camera {
  vcg::Point3d position;
  vcg::Point3d focal_point;
  vcg::Point3d up;
  double height = 1;  ///< of the picture, its width being 1
};

constexpr double view_angle_degrees = 15;  ///< from the lower to the upper rim

/// A picture that just holds all points, half as high as it is wide to square.
/// @param direction  from the object to the camera
/// @param up         not along `direction`
Camera camera_around(const std::vector<vcg::Point3d>& points, vcg::Point3d direction, const vcg::Point3d& up);

/// A square picture of the ball around `center`.
Camera camera_at(const vcg::Point3d& center, double radius, vcg::Point3d direction, const vcg::Point3d& up);

/// As options of f3d, for a picture that many pixels wide.
std::string f3d_options(const Camera& camera, int width);

}  // namespace anisosmooth
