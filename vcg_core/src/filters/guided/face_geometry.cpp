// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_geometry.h"

#include "job.h"

namespace vcg_core::detail {

void FaceGeometry::measure(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  normal.resize(mesh.face.size());
  area.resize(mesh.face.size());
  job.parallel(mesh.face.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const Vec3 vector = area_vector(mesh, position, f);
        normal[f] = in_single(direction_of_face(vector));
        area[f] = vector.norm() / 2;
      }
  });
}

}  // namespace vcg_core::detail
