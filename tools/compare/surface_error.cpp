// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace anisosmooth {
namespace {

using mesh_tools::Mesh;
using vcg::Point3d;

constexpr double degrees = 180 / 3.14159265358979323846;

std::size_t corner(const Mesh& mesh, std::size_t face, int k) { return vcg::tri::Index(mesh, mesh.face[face].cV(k)); }

/// Of twice the face's area's length.
Point3d face_normal(const Mesh& mesh, const Positions& p, std::size_t face) {
  const Point3d& a = p[corner(mesh, face, 0)];
  return (p[corner(mesh, face, 1)] - a) ^ (p[corner(mesh, face, 2)] - a);
}

/// The mean over the faces of each vertex. NaN marks faces to leave out.
std::vector<double> over_vertices(const Mesh& mesh, const std::vector<double>& of_face) {
  std::vector<double> sum(mesh.vert.size(), 0.0);
  std::vector<int> faces(mesh.vert.size(), 0);
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    if (std::isnan(of_face[f])) continue;
    for (int k = 0; k < 3; ++k) {
      sum[corner(mesh, f, k)] += of_face[f];
      ++faces[corner(mesh, f, k)];
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (faces[v] > 0) sum[v] /= faces[v];
  return sum;
}

double angle(const Point3d& a, const Point3d& b) {
  if (!(a.SquaredNorm() > 0) || !(b.SquaredNorm() > 0)) return std::nan("");
  return std::atan2((a ^ b).Norm(), a * b) * degrees;
}

/// Mean direction of each face over all methods.
std::vector<Point3d> consensus(const Comparison& comparison) {
  const Mesh& mesh = comparison.noisy.mesh;
  std::vector<Point3d> sum(mesh.face.size(), Point3d(0, 0, 0));
  for (const MethodRun& run : comparison.runs)
    for (std::size_t f = 0; f < sum.size(); ++f) {
      Point3d n = face_normal(mesh, run.positions, f);
      if (n.SquaredNorm() > 0) sum[f] += n.Normalize();
    }
  return sum;
}

}  // namespace

std::vector<double> normal_errors(const Mesh& mesh, const Positions& a, const Positions& b) {
  std::vector<double> of_face(mesh.face.size());
  for (std::size_t f = 0; f < of_face.size(); ++f) of_face[f] = angle(face_normal(mesh, a, f), face_normal(mesh, b, f));
  return over_vertices(mesh, of_face);
}

std::vector<double> mean_normal_errors(const Comparison& comparison) {
  const Mesh& mesh = comparison.noisy.mesh;
  const Positions truth = comparison.reference ? positions_of(comparison.reference->mesh) : Positions();
  const std::vector<Point3d> mean_normal = comparison.reference ? std::vector<Point3d>() : consensus(comparison);
  std::vector<double> mean(mesh.face.size(), 0.0);
  for (const MethodRun& run : comparison.runs)
    for (std::size_t f = 0; f < mean.size(); ++f)
      mean[f] += angle(face_normal(mesh, run.positions, f),
                       comparison.reference ? face_normal(mesh, truth, f) : mean_normal[f]) /
                 static_cast<double>(comparison.runs.size());
  return over_vertices(mesh, mean);
}

Region strongest_region(const Mesh& mesh, const Positions& positions, const std::vector<double>& error, double radius) {
  using Cell = std::array<long long, 3>;
  struct Sums {
    std::size_t vertices = 0;
    double error = 0;
    Point3d position{0, 0, 0};
  };
  std::map<Cell, Sums> cells;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    Cell cell;
    for (int k = 0; k < 3; ++k) cell[k] = std::llround(std::floor(positions[v][k] / radius));
    Sums& sums = cells[cell];
    ++sums.vertices;
    sums.error += error[v];
    sums.position += positions[v];
  }
  // Cells that the surface only touches do not stand for a region.
  std::vector<std::size_t> counts;
  counts.reserve(cells.size());
  for (const auto& [cell, sums] : cells) counts.push_back(sums.vertices);
  std::nth_element(counts.begin(), counts.begin() + counts.size() / 2, counts.end());
  const std::size_t fewest = counts[counts.size() / 2];

  const Sums* strongest = nullptr;
  const auto mean_error = [](const Sums& sums) { return sums.error / static_cast<double>(sums.vertices); };
  for (const auto& [cell, sums] : cells)
    if (sums.vertices >= fewest && (!strongest || mean_error(sums) > mean_error(*strongest))) strongest = &sums;

  Region region{strongest->position / static_cast<double>(strongest->vertices), Point3d(0, 0, 0), radius};
  for (std::size_t f = 0; f < mesh.face.size(); ++f)
    if ((positions[corner(mesh, f, 0)] - region.center).Norm() < radius)
      region.normal += face_normal(mesh, positions, f);
  if (!(region.normal.SquaredNorm() > 0)) region.normal = Point3d(0, 0, 1);
  region.normal.Normalize();
  return region;
}

}  // namespace anisosmooth
