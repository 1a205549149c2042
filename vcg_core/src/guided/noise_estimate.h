#pragma once

#include <vcg_core/detail/mesh_arrays.h>

#include "face_geometry.h"
#include "face_neighborhoods.h"

namespace vcg_core::detail {

/// Median of at most 2^17 of the values, evenly taken: the same on every machine, and cheap on huge meshes.
/// @param value  is used up; 0 if empty
double median(Array<double> value);

/// Standard deviation of the noise along the normals, in units of `position`, from the heights of the vertices above
/// the mean of their one ring: the median of their absolute values, which few sharp edges do not touch, scaled to a
/// normal distribution. Small features and curvature count as noise, so that a clean mesh has a small one too.
double estimate_noise(const MeshArrays& mesh, const Array<Vec3>& position, const FaceGeometry& faces, Job& job);

/// Median length of the difference of adjoining unit normals.
double median_normal_difference(const Array<Vec3>& normal, const Array<Index>& across);

}  // namespace vcg_core::detail
