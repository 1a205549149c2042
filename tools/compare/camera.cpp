// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace anisosmooth {
namespace {

using vcg::Point3d;

const double half_angle = view_angle_degrees / 2 * 3.14159265358979323846 / 180;
constexpr double margin = 1.03;

}  // namespace

Camera camera_around(const std::vector<Point3d>& points, Point3d direction, const Point3d& up) {
  direction.Normalize();
  const Point3d right = (up ^ direction).Normalize();
  const Point3d above = direction ^ right;
  Point3d low(1e300, 1e300, 1e300), high(-1e300, -1e300, -1e300);
  for (const Point3d& p : points) {
    const Point3d seen(p * right, p * above, p * direction);
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], seen[k]);
      high[k] = std::max(high[k], seen[k]);
    }
  }
  const Point3d middle = (low + high) / 2;
  const Point3d center = right * middle[0] + above * middle[1] + direction * middle[2];
  const double width = high[0] - low[0];
  const double height = high[1] - low[1];
  const double shape = width > 0 ? std::clamp(height / width, 0.5, 1.0) : 1.0;
  const double half_height = margin * std::max(height, width * shape) / 2;
  const double distance = half_height / std::tan(half_angle) + (high[2] - middle[2]);
  return {center + direction * distance, center, up, shape};
}

Camera camera_at(const Point3d& center, double radius, Point3d direction, const Point3d& up) {
  direction.Normalize();
  return {center + direction * (radius / std::tan(half_angle)), center, up, 1};
}

std::string f3d_options(const Camera& camera, int width) {
  std::ostringstream text;
  text.precision(9);
  const auto point = [&](const char* name, const Point3d& p) {
    text << " --camera-" << name << "=" << p[0] << "," << p[1] << "," << p[2];
  };
  point("position", camera.position);
  point("focal-point", camera.focal_point);
  point("view-up", camera.up);
  text << " --camera-view-angle=" << view_angle_degrees << " --resolution=" << width << ","
       << std::lround(width * camera.height);
  return text.str();
}

}  // namespace anisosmooth
