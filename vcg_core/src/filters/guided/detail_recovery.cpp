// SPDX-License-Identifier: GPL-3.0-or-later
#include "detail_recovery.h"

#include <algorithm>
#include <cmath>

#include "face_geometry.h"
#include "job.h"
#include "mean_normals.h"
#include "ring_means.h"

namespace vcg_core::detail {

namespace {

/// Low-passes over these numbers of rings.
constexpr int scales[] = {3, 1};

/// Variance that a low-pass over k rings leaves of white noise of variance 1: about this over k, from the heat kernel
/// on the lattice of equilateral triangles (1/7 exactly for one ring).
constexpr double variance_of_one_ring = 0.155;

/// Rings over which energies are averaged, beyond those of the low-pass itself.
constexpr int energy_rings = 16;

/// Standard deviation of white noise of 1 less its mean over one ring, sqrt(1 - 1/7), and the median of the absolute
/// value of a normal distribution.
constexpr double noise_above_ring = 0.926;
constexpr double median_of_normal = 0.6745;

double noise_of(const Array<double>& residual, const Array<double>& one_ring, WholeMedians& medians, Job& job) {
  Array<double> above(residual.size());
  job.serial(above.size(), [&](std::size_t v) { above[v] = std::abs(residual[v] - one_ring[v]); });
  return medians.of_vertices(above) / (median_of_normal * noise_above_ring);
}

/// The part of the low-passed residual that is shape, by its energy in units of white noise's.
double share_of_shape(double energy, const GuidedSettings& settings) {
  if (!(energy > settings.detail_from)) return 0;
  const double ramp = (energy - settings.detail_from) / (settings.detail_full - settings.detail_from);
  return std::max(0.0, 1 - 1 / energy) * std::min(1.0, ramp);
}

}  // namespace

void recover_detail(const MeshArrays& mesh, const Array<Vec3>& noisy, const Array<std::uint8_t>& movable,
                    const GuidedSettings& settings, WholeMedians& medians, Array<Vec3>& position, Job& job) {
  const RingMeans rings(mesh, job);
  double noise = -1;
  FaceGeometry faces;
  for (const int scale : scales) {
    faces.measure(mesh, position, job);
    const Array<Vec3> normal = mean_normals(mesh, faces.normal, job);
    Array<double> residual(mesh.size());
    job.serial(residual.size(), [&](std::size_t v) { residual[v] = (noisy[v] - position[v]).dot(normal[v]); });
    if (noise < 0) noise = settings.noise_scale * noise_of(residual, low_pass(rings, residual, 1, job), medians, job);
    const Array<double> low = low_pass(rings, residual, scale, job);
    const double expected = noise * noise * variance_of_one_ring / scale;
    Array<double> energy(low.size());
    job.serial(low.size(), [&](std::size_t v) { energy[v] = low[v] * low[v]; });
    energy = low_pass(rings, std::move(energy), energy_rings + scale, job);
    job.serial(low.size(), [&](std::size_t v) {
      if (!movable[v]) return;
      // Without any noise all of the residual is shape.
      const double share = expected > 0 ? share_of_shape(energy[v] / expected, settings) : 1;
      position[v] += share * low[v] * normal[v];
    });
  }
}

}  // namespace vcg_core::detail
