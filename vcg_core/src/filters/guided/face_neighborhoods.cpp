// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_neighborhoods.h"

#include <algorithm>

#include "face_geometry.h"
#include "faces_around.h"
#include "job.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 2048;

/// Mean length of the edges at v as its faces see them: inner ones twice.
double mean_edge_length(const MeshArrays& mesh, Index v, double otherwise) {
  const MeshTopology& topology = mesh.topology;
  double sum = 0;
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Index corner = topology.star[s];
    sum += (mesh.position[vertex_of(mesh, next_in_face(corner))] - mesh.position[v]).norm();
    sum += (mesh.position[vertex_of(mesh, previous_in_face(corner))] - mesh.position[v]).norm();
  }
  const std::size_t count = 2 * faces_of(topology, v);
  return count > 0 ? sum / static_cast<double>(count) : otherwise;
}

Array<double> mean_over_ring(const MeshArrays& mesh, const Array<double>& value, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<double> mean(mesh.size());
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        double sum = value[v];
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
          const Index corner = topology.star[s];
          sum += value[vertex_of(mesh, next_in_face(corner))] + value[vertex_of(mesh, previous_in_face(corner))];
        }
        mean[v] = sum / static_cast<double>(1 + 2 * faces_of(topology, static_cast<Index>(v)));
      }
  });
  return mean;
}

/// Finds neighbourhoods. Each thread has one of its own.
class Ball {
 public:
  /// Refers to all.
  Ball(const MeshArrays& mesh, const Array<Index>& across, const Array<Vec3>& centroid)
      : mesh_(mesh),
        across_(across),
        centroid_(centroid),
        faces_(centroid.size()),
        vertices_(mesh.size()),
        around_(mesh, across) {}

  void forget_all() {
    faces_.forget_all();
    vertices_.forget_all();
    around_.forget_all();
  }

  /// Valid until the next call.
  const Array<Index>& find(Index f, double radius) {
    constexpr std::size_t fewest = 4;
    const double limit = radius * radius;
    faces_.begin(f);
    vertices_.begin(f);
    list_.clear();
    const auto add = [&](Index g) {
      if (list_.size() < FaceLists::longest && faces_.add(g) &&
          (g == f || (centroid_[g] - centroid_[f]).squaredNorm() < limit))
        list_.push_back(g);
    };
    const auto add_all = [&](Index v) {
      if (vertices_.add(v)) visit_faces_of(mesh_.topology, v, add);
    };
    add(f);
    for (std::size_t k = 0; k < list_.size() && list_.size() < FaceLists::longest; ++k)
      visit_faces_around(mesh_, across_, list_[k], add, add_all);
    if (list_.size() < fewest)
      for (const Index g : around_.find(f))
        if (std::find(list_.begin(), list_.end(), g) == list_.end()) list_.push_back(g);
    return list_;
  }

 private:
  const MeshArrays& mesh_;
  const Array<Index>& across_;
  const Array<Vec3>& centroid_;
  Marks faces_, vertices_;
  FacesAround around_;
  Array<Index> list_;
};

Array<Vec3> centroids(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  Array<Vec3> centroid(mesh.face.size());
  job.parallel(centroid.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) centroid[f] = centroid_of(mesh, position, f);
  });
  return centroid;
}

}  // namespace

Array<double> local_spacing(const MeshArrays& mesh, bool follow_edge_length, double least, Job& job) {
  constexpr int rings = 3;
  constexpr double centroids_per_edge = 0.6;  // about: 1 / sqrt(3) between equilateral triangles
  constexpr double shortest = 1e-6;           // |e|; a neighbourhood has an extent even where all vertices coincide
  const double e = mesh.topology.average_edge_length;
  Array<double> spacing(mesh.face.size(), centroids_per_edge * e);
  if (!follow_edge_length) return spacing;
  const double limit = std::max(std::min(least, centroids_per_edge * e), shortest * e);
  Array<double> length(mesh.size());
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        length[v] = mean_edge_length(mesh, static_cast<Index>(v), e);
  });
  for (int ring = 0; ring < rings; ++ring) length = mean_over_ring(mesh, length, job);
  job.serial(spacing.size(), [&](std::size_t f) {
    const auto& v = mesh.face[f];
    spacing[f] = std::max(centroids_per_edge * (length[v[0]] + length[v[1]] + length[v[2]]) / 3, limit);
  });
  return spacing;
}

FaceLists faces_within(const MeshArrays& mesh, const Array<Index>& across, const Array<Vec3>& position,
                       const Array<double>& spacing, double radius, Job& job) {
  const Array<Vec3> centroid = centroids(mesh, position, job);
  FaceLists lists(spacing.size());
  job.parallel(lists.blocks(), grain / FaceLists::block_size, Loop::minor, [&](Chunks& chunks) {
    Ball ball(mesh, across, centroid);
    FaceLists::Writer writer(lists);
    while (chunks.next()) {
      ball.forget_all();
      for (std::size_t b = chunks.begin(); b < chunks.end(); ++b)
        writer.write(b, [&](Index f) -> const Array<Index>& { return ball.find(f, radius * spacing[f]); });
    }
  });
  lists.number_entries();
  return lists;
}

}  // namespace vcg_core::detail
