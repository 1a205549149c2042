// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/comparison.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace test_support {

Difference difference(const FlatMesh& a, const FlatMesh& b, double tolerance) {
  Difference result;
  for (std::size_t v = 0; v < a.points.size(); ++v) {
    const double d = (a.points[v] - b.points[v]).Norm();
    if (!(d <= tolerance)) ++result.beyond_tolerance;
    if (!(d <= result.largest)) {
      result.largest = d;
      result.at = v;
    }
  }
  return result;
}

testing::AssertionResult same_smoothing(const FlatMesh& a, const FlatMesh& b, const SmoothingPath& path, double e) {
  if (a.points.size() != b.points.size()) return testing::AssertionFailure() << "different numbers of vertices";
  const Difference d = difference(a, b, path.position_tolerance * e);
  if (static_cast<double>(d.beyond_tolerance) <= path.ambiguous_share * static_cast<double>(a.points.size()))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << d.beyond_tolerance << " of " << a.points.size()
                                     << " vertices differ by more than " << path.position_tolerance
                                     << " |e|; the largest difference is " << d.largest / e << " |e| at vertex "
                                     << d.at;
}

bool all_finite(const FlatMesh& mesh) {
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); });
}

bool same_bits(const FlatMesh& a, const FlatMesh& b) {
  if (a.points.size() != b.points.size()) return false;
  for (std::size_t v = 0; v < a.points.size(); ++v)
    for (int k = 0; k < 3; ++k)
      if (std::memcmp(&a.points[v][k], &b.points[v][k], sizeof(double)) != 0) return false;
  return true;
}

}  // namespace test_support
