// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#include <vcg/complex/algorithms/create/marching_cubes.h>
#include <vcg/complex/algorithms/create/mc_trivial_walker.h>

#include "sine_field.h"
#include "training_mesh.h"

namespace training {

namespace {

using mesh_tools::Mesh;
using mesh_tools::Random;
using vcg::Point3d;

/// About the distance from the surface, negative inside: balls, boxes, rods and rings, joined and cut.
class Solid {
 public:
  /// @param size  of the cube, from 0 to size, that holds it
  Solid(Random& random, double size) : smooth_(random.uniform() < 0.5) {
    const int count = 1 + static_cast<int>(random.uniform() * 4);
    for (int i = 0; i < count; ++i) {
      Part part;
      part.kind = choose(random, {1.2, 1, 0.8, 0.8});
      part.center = Point3d(1, 1, 1) * (size / 2);
      if (i > 0) part.center += random.direction() * between(random, 0.05, 0.28) * size;
      const double reach = (i == 0 ? between(random, 0.24, 0.36) : between(random, 0.08, 0.24)) * size;
      part.size = Point3d(reach, reach * between(random, 0.4, 1), reach * between(random, 0.25, 1));
      part.axis[0] = random.uniform() < 0.3 ? Point3d(1, 0, 0) : random.direction();
      part.axis[1] = (part.axis[0] ^ random.direction()).Normalize();
      part.axis[2] = part.axis[0] ^ part.axis[1];
      part.cut = i > 0 && random.uniform() < 0.35;
      parts_.push_back(part);
    }
    if (random.uniform() < 0.6)
      waves_.add(random, between(random, 3, 14) / size, between(random, 0.005, 0.03) * size, 8);
  }

  double operator()(const Point3d& place) const {
    const Point3d p = place + waves_(place);
    double distance = 1e9;
    for (const Part& part : parts_) {
      const double own = part.distance(p);
      distance = part.cut ? std::max(distance, -own) : smooth_ ? joined(distance, own, 2) : std::min(distance, own);
    }
    return distance;
  }

  Point3d normal(const Point3d& p) const {
    constexpr double step = 0.05;
    Point3d gradient;
    for (int k = 0; k < 3; ++k) {
      Point3d d(0, 0, 0);
      d[k] = step;
      gradient[k] = (*this)(p + d) - (*this)(p - d);
    }
    const double length = gradient.Norm();
    return length > 0 ? gradient / length : Point3d(0, 0, 0);
  }

 private:
  struct Part {
    std::size_t kind = 0;
    Point3d center, size;
    std::array<Point3d, 3> axis;
    bool cut = false;

    double distance(const Point3d& place) const {
      const Point3d d = place - center;
      const Point3d p(d * axis[0], d * axis[1], d * axis[2]);
      switch (kind) {
        case 0:
          return p.Norm() - size[0];
        case 1: {
          const Point3d q(std::abs(p[0]) - size[0], std::abs(p[1]) - size[1], std::abs(p[2]) - size[2]);
          const Point3d out(std::max(q[0], 0.0), std::max(q[1], 0.0), std::max(q[2], 0.0));
          return out.Norm() + std::min(0.0, std::max({q[0], q[1], q[2]}));
        }
        case 2: {
          const double along = std::abs(p[0]) - size[0], across = std::hypot(p[1], p[2]) - 0.5 * size[1];
          return std::max(along, across);
        }
        default:
          return std::hypot(std::hypot(p[0], p[1]) - 0.75 * size[0], p[2]) - 0.3 * size[1];
      }
    }
  };

  /// The smaller one, rounded where they are near each other.
  static double joined(double a, double b, double width) {
    const double h = std::max(0.0, width - std::abs(a - b)) / width;
    return std::min(a, b) - h * h * width / 4;
  }

  bool smooth_;
  std::vector<Part> parts_;
  SineField waves_;
};

using Volume = vcg::SimpleVolume<vcg::SimpleVoxel<float>>;

/// Marching cubes over value(x, y, z) at the grid's points, at the level 0; in units of the grid.
template <class Value>
Mesh marched(const vcg::Point3i& size, const Value& value) {
  Volume volume;
  vcg::Box3f box(vcg::Point3f(0, 0, 0), vcg::Point3f(float(size[0]), float(size[1]), float(size[2])));
  volume.Init(size, box);
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x) volume.Val(x, y, z) = static_cast<float>(value(x, y, z));
  using Walker = vcg::tri::TrivialWalker<Mesh, Volume>;
  Walker walker;
  Mesh mesh;
  vcg::tri::MarchingCubes<Mesh, Walker> marching(mesh, walker);
  walker.BuildMesh(mesh, volume, marching, 0);
  return mesh;
}

void orient_outwards(Mesh& mesh) {
  if (mesh_tools::signed_volume(mesh) < 0)
    for (auto& f : mesh.face) std::swap(f.V(1), f.V(2));
}

/// Noise of standard deviation 1 at the points of a grid, averaged with the points around up to three times.
std::vector<double> volume_noise(int n, Random& random) {
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> noise(size * size * size), mean(noise.size());
  for (double& value : noise) value = random.normal();
  const std::size_t stride[] = {1, size, size * size};
  for (std::size_t times = choose(random, {1, 1, 1, 1}); times > 0; --times)
    for (const std::size_t step : stride) {
      mean = noise;
      for (std::size_t i = step; i + step < noise.size(); ++i)
        mean[i] = noise[i] / 2 + (noise[i - step] + noise[i + step]) / 4;
      noise.swap(mean);
    }
  double square = 0;
  for (const double value : noise) square += value * value / static_cast<double>(noise.size());
  for (double& value : noise) value /= std::sqrt(square);
  return noise;
}

}  // namespace

Mesh isosurface(Random& random) {
  const int n = static_cast<int>(between(random, 36, 64));
  const Solid solid(random, n);
  Mesh mesh = marched({n, n, n}, [&](int x, int y, int z) { return solid({double(x), double(y), double(z)}); });
  orient_outwards(mesh);
  return mesh;
}

VolumeSurface fused_surface(Random& random) {
  const int n = static_cast<int>(between(random, 36, 64));
  const Solid solid(random, n);
  const std::vector<double> noise = volume_noise(n, random);
  const double level = between(random, 0.05, 0.45);
  VolumeSurface result;
  result.mesh = marched({n, n, n}, [&](int x, int y, int z) {
    return solid({double(x), double(y), double(z)}) + level * noise[static_cast<std::size_t>((z * n + y) * n + x)];
  });
  orient_outwards(result.mesh);
  for (auto& f : result.mesh.face) {
    // Down to the surface, where the normal is that of the solid.
    Point3d place = (f.P(0) + f.P(1) + f.P(2)) / 3;
    place -= solid.normal(place) * solid(place);
    result.normal.push_back(solid.normal(place));
  }
  vcg::tri::UpdateBounding<Mesh>::Box(result.mesh);
  return result;
}

VolumeSurface label_surface(Random& random) {
  const double slice = choose(random, {1, 1}) == 0 ? 1 : between(random, 1, 6);
  const int n = static_cast<int>(between(random, 40, 70) * std::pow(slice, 1. / 3));
  const Solid solid(random, n);
  const vcg::Point3i size(n, n, static_cast<int>(n / slice) + 1);
  const auto place = [&](const Point3d& p) { return Point3d(p[0], p[1], slice * p[2]); };
  VolumeSurface result;
  result.mesh = marched(size, [&](int x, int y, int z) {
    return solid(place({double(x), double(y), double(z)})) < 0 ? -1.0 : 1.0;
  });
  orient_outwards(result.mesh);
  // Each vertex lies halfway along an edge of the grid, and should lie where the surface crosses it.
  std::vector<Point3d> ideal;
  for (auto& v : result.mesh.vert) {
    Point3d a = v.P(), b = v.P();
    for (int k = 0; k < 3; ++k)
      if (v.P()[k] != std::floor(v.P()[k])) {
        a[k] = std::floor(v.P()[k]);
        b[k] = a[k] + 1;
      }
    const double at_a = solid(place(a)), at_b = solid(place(b));
    const double part = at_a != at_b ? std::clamp(at_a / (at_a - at_b), 0.0, 1.0) : 0.5;
    ideal.push_back(place(a + (b - a) * part));
    v.P() = place(v.P());
  }
  for (auto& f : result.mesh.face) {
    Point3d center(0, 0, 0);
    for (int k = 0; k < 3; ++k) center += ideal[vcg::tri::Index(result.mesh, f.V(k))] / 3;
    result.normal.push_back(solid.normal(center));
  }
  vcg::tri::UpdateBounding<Mesh>::Box(result.mesh);
  return result;
}

}  // namespace training
