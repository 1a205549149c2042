// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_arrays.h"
#include "virtual_start.h"

namespace vcg_core::detail {

/// The frame of a face at one of its corners. Lengths are those of `position` divided by `unit`.
template <class Scalar>
TriangleFrame<Scalar> triangle_frame(const MeshArrays& mesh, const Array<Vec3>& position, Index corner, Scalar unit);

/// Frames in the mesh's own unit, computed when they are asked for: a march from a single source needs each but once or
/// twice, and memory for all of them takes longer to get than a user who cancels wants to wait.
class FramesOnDemand {
 public:
  explicit FramesOnDemand(const MeshArrays& mesh) : mesh_(mesh) {}
  TriangleFrame<long double> operator[](Index corner) const {
    return triangle_frame(mesh_, mesh_.position, corner, 1.0L);  // a division by |e| would round each length
  }

 private:
  const MeshArrays& mesh_;
};

/// The frame of every face at each of its corners, by corner. Lengths are those of `position` divided by `unit`.
template <class Scalar>
Array<TriangleFrame<Scalar>> triangle_frames(const MeshArrays& mesh, const Array<Vec3>& position, Scalar unit,
                                             Job& job);

}  // namespace vcg_core::detail
