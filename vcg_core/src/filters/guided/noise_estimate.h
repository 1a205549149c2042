// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"
#include "ring_means.h"

namespace vcg_core::detail {

/// The noise of a mesh, as far as it can be told from its shape.
struct NoiseEstimate {
  Array<double> deviation;  ///< by vertex: standard deviation along the normal, in units of the positions
  double mean = 0;          ///< root of the mean square over all vertices
  double evidence = 0;      ///< share of the vertices around which there is more noise than shape
  bool correlated = false;  ///< over some edges, so that neighbours agree
};

/// The same for all vertices.
NoiseEstimate even_noise(const MeshArrays& mesh, double deviation);

/// Estimates the noise around each vertex.
///
/// Let h_v be the height of a vertex above the mean of its one ring, and m_v the mean of the heights at its neighbours.
/// Independent noise makes them opposed: a vertex that is too high makes its neighbours look too low, and -h_v m_v has
/// the expectation sigma^2 t_v with t_v known from the valences. Shape makes them agree: along an edge, a ridge or a
/// bend the neighbours rise with the vertex. So the opposed part, a_v = max(0, -h_v m_v), measures the noise, the
/// agreeing part, b_v = max(0, h_v m_v), the shape, and a / (a + b), each averaged over a dozen rings, tells whether
/// what is seen around a vertex is noise (0.93 for white noise on a plane, 0 to 0.2 on clean models).
///
/// Where shape prevails, as at the edges of machine parts, a is too large; there the estimate is at most that of the
/// nearest vertices around which noise prevails. Where noise prevails almost nowhere, the mesh gives no evidence of
/// any, and the estimate is 0: a cube of twelve triangles is a cube, not a noisy sphere.
///
/// Noise that varies from vertex to vertex is seen. Steps of voxels alternate as noise does and are seen as such; noise
/// that is correlated over several edges is taken for shape: see find_correlated_noise(). New here.
///
/// In a piece of a larger mesh what is told of the whole takes the place of the sums.
NoiseEstimate estimate_noise(const MeshArrays& mesh, const RingMeans& rings, const Array<Vec3>& position, Job& job);

/// What a piece is told of the noise: all but the deviations, which are left empty.
NoiseEstimate told_noise(const GuidedWhole& whole);

/// What is seen around each vertex, which counts as far as the whole mesh bears it out.
struct NoiseSeen {
  Array<double> of_stairs;           ///< standard deviations; empty if there are no stairs, else all that there is
  GuidedWhole::Testimony testimony;  ///< over the vertices that count
  Array<double> variance;            ///< by what is seen around; by vertex, as are the next two
  Array<double> near_by;             ///< variance by the trusted vertices around
  Array<double> confidence;          ///< whether these are enough: from 0 to 1
};

NoiseSeen look_for_noise(const MeshArrays& mesh, const RingMeans& rings, const Array<Vec3>& position, Job& job);

/// What follows for a vertex from what is seen in the whole mesh.
class NoiseByWhole {
 public:
  explicit NoiseByWhole(const GuidedWhole::Testimony& testimony);

  double evidence() const { return share_; }  ///< as NoiseEstimate has it
  double variance(double by_vertex, double near_by, double confidence) const;

 private:
  double share_, believed_, of_all_;
};

}  // namespace vcg_core::detail
