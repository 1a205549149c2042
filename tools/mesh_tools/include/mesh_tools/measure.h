// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>

#include <mesh_tools/mesh.h>

namespace mesh_tools {

/// The meshes to compare do not have the same vertices and faces.
class DifferentConnectivity : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Angles in degrees between corresponding faces, each face counted once whatever its size.
struct AngleStatistics {
  std::size_t faces = 0;
  double mean = 0, median = 0, percentile_95 = 0;  ///< 0 if there are no faces
};

/// Lengths are in average edge lengths |e| of the reference.
struct Measurement {
  std::size_t vertices = 0, faces = 0;
  double average_edge_length = 0;  ///< |e| of the reference, in its own unit

  /// Angle between a face's normal and its normal in the reference. Faces without area in either mesh are left out.
  AngleStatistics normal_error;
  /// The same over faces with at least one vertex on a sharp edge: an edge of the reference with two faces whose
  /// normals differ by more than 30 degrees.
  AngleStatistics sharp_normal_error;
  std::size_t flipped_faces = 0;     ///< turned by more than 90 degrees
  std::size_t degenerate_faces = 0;  ///< without area in the result

  double distance_rms = 0, distance_max = 0;                  ///< from the result's vertices to the reference's surface
  double reverse_distance_rms = 0, reverse_distance_max = 0;  ///< from the reference's vertices to the result's surface

  /// (volume of the result - volume of the reference) / |volume of the reference|, of the cone over the faces from the
  /// centre of the reference's box; for closed meshes the enclosed volume. Empty where the reference has none.
  std::optional<double> volume_change_percent;

  /// RMS over the vertices of the part of (result - reference) that is orthogonal to the reference's vertex normal.
  double true_tangential_drift = 0;
  /// RMS over the vertices of the part of (result - noisy) that is orthogonal to the noisy mesh's vertex normal.
  std::optional<double> tangential_drift;
};

/// Compares a smoothed mesh with the truth of the same connectivity.
/// @param noisy    the mesh before smoothing, or null
/// @param threads  0: one for each processor; the result does not depend on it
/// @throws DifferentConnectivity, std::invalid_argument (no faces, a coordinate that is not finite)
Measurement measure(const Mesh& result, const Mesh& reference, const Mesh* noisy = nullptr, int threads = 0);

}  // namespace mesh_tools
