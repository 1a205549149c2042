// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter.h"

namespace vcg_core::detail {

/// Non-iterative, feature-preserving mesh smoothing (Jones, Durand, Desbrun 2003).
///
/// Each face q within the cut-off distance predicts where vertex p belongs: at the projection of p onto the plane
/// through the face's centroid with the face's mollified normal. p moves to the mean of the predictions, weighted by
/// the face's area, a Gaussian of the distance from p to the centroid (sigma_c), and a Gaussian of the distance from p
/// to the prediction (sigma_s). The normals are those of the faces of a mollified copy of the mesh: the same mean with
/// half the spatial width, no influence weight, and the centroids themselves as predictions.
///
/// Where the code differs: the Gaussians are cut off at rho sigma_c (rho sigma_c / 2 for the copy), rho = 2. Vertices
/// without a weight that counts (no centroid so near, as on coarse parts of a graded mesh) stay where they are, and so
/// do those of the copy; the article does not mention them.
Filter jones_filter();

}  // namespace vcg_core::detail
