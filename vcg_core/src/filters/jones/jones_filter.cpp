// SPDX-License-Identifier: GPL-3.0-or-later
#include "jones_filter.h"

#include <atomic>
#include <cmath>

#include <Eigen/Geometry>

#include "job.h"
#include "point_grid.h"
#include "polled_copy.h"

namespace vcg_core::detail {

namespace {

struct FaceMeans {
  Array<Vec3> centroid;
  Array<double> area;  ///< in |e|^2
};

Vec3 face_cross(const MeshArrays& mesh, const Array<Vec3>& position, std::size_t f) {
  const auto& face = mesh.face[f];
  const Vec3& a = position[face[0]];
  return (position[face[1]] - a).cross(position[face[2]] - a);
}

FaceMeans face_means(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  const double unit = mesh.topology.average_edge_length;
  FaceMeans means{Array<Vec3>(mesh.face.size()), Array<double>(mesh.face.size())};
  job.parallel(mesh.face.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const auto& face = mesh.face[f];
        means.centroid[f] = (position[face[0]] + position[face[1]] + position[face[2]]) / 3;
        means.area[f] = (face_cross(mesh, position, f) / (unit * unit)).norm() / 2;
      }
  });
  return means;
}

Array<Index> faces_with_area(const FaceMeans& means, Job& job) {
  Array<Index> faces;
  faces.reserve(means.area.size());
  job.serial(means.area.size(), [&](std::size_t f) {
    if (means.area[f] > 0) faces.push_back(static_cast<Index>(f));
  });
  return faces;
}

/// What a Gaussian of standard deviation sigma raises e to.
double exponent(double squared_argument, double sigma) { return -squared_argument / sigma / sigma / 2; }

/// The vertices of the copy that lends its normals: all that have faces, movable or not. The progress
/// bar waits meanwhile, so that it does not stand at its end through the predictions.
Array<Vec3> mollified_positions(const PassInput& in, const BilateralParameters& parameters, const FaceMeans& means,
                                const Array<Index>& faces) {
  const double unit = in.mesh.topology.average_edge_length;
  const double sigma = parameters.sigma_c / 2;
  const PointGrid grid(means.centroid, faces, parameters.rho * sigma * unit, &in.job);
  in.job.poll();
  Array<Vec3> mollified = polled_copy(in.position, in.job);
  in.job.parallel(in.mesh.size(), 256, Loop::minor, [&](Chunks& chunks) {
    PointGrid::Search ball(grid);
    while (chunks.next())
      for (std::size_t i = chunks.begin(); i < chunks.end(); ++i) {
        if (in.mesh.topology.star_begin[i] == in.mesh.topology.star_begin[i + 1]) continue;
        chunks.poll();
        const Vec3& p = in.position[i];
        Vec3 sum = Vec3::Zero();
        double sum_of_weights = 0;
        ball.for_each_near(p, [&](Index q, const Vec3& centroid) {
          const Vec3 to_centroid = (centroid - p) / unit;
          const double w = means.area[q] * std::exp(exponent(to_centroid.squaredNorm(), sigma));
          sum += w * to_centroid;
          sum_of_weights += w;
        });
        if (sum_of_weights > 0) mollified[i] += sum / sum_of_weights * unit;
      }
  });
  return mollified;
}

/// Unit normals of the faces; zero for those without area.
Array<Vec3> face_normals(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  Array<Vec3> normal(mesh.face.size());
  job.parallel(mesh.face.size(), 4096, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f)
        normal[f] = face_cross(mesh, position, f).stableNormalized();
  });
  return normal;
}

PassOutput jones_pass(const PassInput& in, const BilateralParameters& parameters) {
  const double unit = in.mesh.topology.average_edge_length;
  const double sigma_c = parameters.sigma_c;
  const double sigma_s = parameters.sigma_s;
  const FaceMeans means = face_means(in.mesh, in.position, in.job);
  const Array<Index> faces = faces_with_area(means, in.job);
  const Array<Vec3> normal = face_normals(in.mesh, mollified_positions(in, parameters, means, faces), in.job);

  in.job.poll();
  const PointGrid grid(means.centroid, faces, parameters.rho * sigma_c * unit, &in.job);
  in.job.poll();
  PassOutput out{polled_copy(in.position, in.job)};
  std::atomic<std::size_t> empty{0};
  in.job.parallel(in.mesh.size(), 256, [&](Chunks& chunks) {
    PointGrid::Search ball(grid);
    while (chunks.next())
      for (std::size_t i = chunks.begin(); i < chunks.end(); ++i) {
        if (!in.movable[i]) continue;
        chunks.poll();
        const Vec3& p = in.position[i];
        Vec3 sum = Vec3::Zero();  // of the displacements from p to its predictions, in |e|
        double sum_of_weights = 0;
        ball.for_each_near(p, [&](Index q, const Vec3& centroid) {
          if (normal[q].isZero(0)) return;
          const Vec3 from_centroid = (p - centroid) / unit;
          const double height = normal[q].dot(from_centroid);
          const double w = means.area[q] * std::exp(exponent(from_centroid.squaredNorm(), sigma_c) +
                                                    exponent(height * height, sigma_s));
          sum -= w * height * normal[q];
          sum_of_weights += w;
        });
        if (sum_of_weights > 0)
          out.position[i] += sum / sum_of_weights * unit;
        else
          empty += in.mesh.copies(i);
      }
  });
  out.empty_neighbourhoods = empty;
  return out;
}

}  // namespace

Filter jones_filter() {
  const BilateralRows<SmoothingParameters> bilateral;
  const CommonRows<SmoothingParameters> common;
  return {{Method::jones,
           "jones",
           "Non-iterative feature-preserving smoothing",
           {bilateral.sigma_c, bilateral.sigma_s, common.boundary, common.selected, bilateral.rho,
            without_label(common.iterations)}},
          "use the guided filter; a smaller sigma_s moves less",
          false,
          [](const SmoothingParameters& all) { return bind_pass<BilateralParameters>(jones_pass, all); }};
}

}  // namespace vcg_core::detail
