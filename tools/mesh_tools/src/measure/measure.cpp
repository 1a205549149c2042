// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/measure.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <tuple>
#include <vector>

#include <mesh_tools/noise.h>

#include "closest_point.h"

namespace mesh_tools {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double sharp_angle = 30;

double angle_in_degrees(const vcg::Point3d& a, const vcg::Point3d& b) {
  return std::atan2((a ^ b).Norm(), a * b) * 180 / pi;
}

void check(const Mesh& mesh, const char* name) {
  if (mesh.fn == 0) throw std::invalid_argument(std::string("the ") + name + " mesh has no faces");
  for (std::size_t i = 0; i < mesh.vert.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(mesh.vert[i].cP()[k]))
        throw std::invalid_argument(std::string("the ") + name + " mesh: vertex " + std::to_string(i) +
                                    " has a coordinate that is not finite");
}

void check_same(const Mesh& mesh, const char* name, const Mesh& reference) {
  const std::string start = std::string("the ") + name + " mesh and the reference must have the same connectivity: ";
  const auto counts = [](const Mesh& m) {
    return std::to_string(m.vert.size()) + " vertices and " + std::to_string(m.face.size()) + " faces";
  };
  if (mesh.vert.size() != reference.vert.size() || mesh.face.size() != reference.face.size())
    throw DifferentConnectivity(start + counts(mesh) + " against " + counts(reference));
  for (std::size_t i = 0; i < mesh.face.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (vcg::tri::Index(mesh, mesh.face[i].cV(k)) != vcg::tri::Index(reference, reference.face[i].cV(k)))
        throw DifferentConnectivity(start + "face " + std::to_string(i) + " has other vertices");
}

/// Normals of twice the area's length; their direction alone matters.
std::vector<vcg::Point3d> face_normals(const Mesh& mesh) {
  std::vector<vcg::Point3d> normals;
  normals.reserve(mesh.face.size());
  for (const auto& face : mesh.face) normals.push_back((face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0)));
  return normals;
}

/// Vertices on an edge of exactly two faces whose normals differ by more than the sharp angle.
std::vector<char> sharp_vertices(const Mesh& mesh, const std::vector<vcg::Point3d>& normals) {
  struct Side {
    std::size_t low, high, face;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.face.size());
  for (std::size_t i = 0; i < mesh.face.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = vcg::tri::Index(mesh, mesh.face[i].cV(k));
      const std::size_t b = vcg::tri::Index(mesh, mesh.face[i].cV((k + 1) % 3));
      sides.push_back({std::min(a, b), std::max(a, b), i});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  std::vector<char> sharp(mesh.vert.size(), 0);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    if (end - i == 2) {
      const vcg::Point3d &a = normals[sides[i].face], &b = normals[sides[i + 1].face];
      const bool has_area = a.SquaredNorm() > 0 && b.SquaredNorm() > 0;
      if (has_area && angle_in_degrees(a, b) > sharp_angle) sharp[sides[i].low] = sharp[sides[i].high] = 1;
    }
    i = end;
  }
  return sharp;
}

/// Quantile by linear interpolation between the two nearest of the sorted values.
double quantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place), above = std::min(below + 1, sorted.size() - 1);
  const double part = place - static_cast<double>(below);
  return (1 - part) * sorted[below] + part * sorted[above];
}

AngleStatistics statistics(std::vector<double> angles) {
  AngleStatistics result;
  result.faces = angles.size();
  if (angles.empty()) return result;
  std::sort(angles.begin(), angles.end());
  for (double angle : angles) result.mean += angle;
  result.mean /= static_cast<double>(angles.size());
  result.median = quantile(angles, 0.5);
  result.percentile_95 = quantile(angles, 0.95);
  return result;
}

void measure_normals(const Mesh& result, const Mesh& reference, Measurement& figures) {
  const std::vector<vcg::Point3d> normals = face_normals(result), truth = face_normals(reference);
  const std::vector<char> sharp = sharp_vertices(reference, truth);
  std::vector<double> all, at_edges;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const bool has_area = normals[i].SquaredNorm() > 0;
    if (!has_area) ++figures.degenerate_faces;
    if (!has_area || !(truth[i].SquaredNorm() > 0)) continue;
    const double angle = angle_in_degrees(normals[i], truth[i]);
    all.push_back(angle);
    if (angle > 90) ++figures.flipped_faces;
    bool is_sharp = false;
    for (int k = 0; k < 3; ++k) is_sharp |= sharp[vcg::tri::Index(reference, reference.face[i].cV(k))] != 0;
    if (is_sharp) at_edges.push_back(angle);
  }
  figures.normal_error = statistics(std::move(all));
  figures.sharp_normal_error = statistics(std::move(at_edges));
}

/// RMS and maximum of the distances from the vertices of `from` to the surface of `to`; isolated vertices do not count.
void measure_distance(const Mesh& from, const Mesh& to, int threads, double& rms, double& max) {
  const SurfaceDistance distance_to(to);
  std::vector<char> used(from.vert.size(), 0);
  for (const auto& face : from.face)
    for (int k = 0; k < 3; ++k) used[vcg::tri::Index(from, face.cV(k))] = 1;
  std::vector<double> distance(from.vert.size(), 0.0);
  std::atomic<std::size_t> next{0};
  constexpr std::size_t chunk = 4096;
  const auto work = [&] {
    for (std::size_t first; (first = next.fetch_add(chunk)) < distance.size();)
      for (std::size_t i = first; i < std::min(first + chunk, distance.size()); ++i) {
        // The same vertex of the other mesh lies on its surface, so its distance bounds the search.
        const double bound = (from.vert[i].cP() - to.vert[i].cP()).Norm();
        if (used[i]) distance[i] = distance_to(from.vert[i].cP(), bound);
      }
  };
  const int wanted = threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> pool;
  pool.reserve(static_cast<std::size_t>(wanted));
  try {
    for (int i = 1; i < wanted; ++i) pool.emplace_back(work);
  } catch (const std::system_error&) {
    // The system has no more threads to give: those that started, and this one, do the work.
  } catch (const std::bad_alloc&) {
    // The same.
  }
  work();
  for (std::thread& thread : pool) thread.join();
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (!used[i]) continue;
    sum += distance[i] * distance[i];
    max = std::max(max, distance[i]);
    ++count;
  }
  rms = std::sqrt(sum / static_cast<double>(count));
}

double volume_about(const Mesh& mesh, const vcg::Point3d& centre) {
  double sum = 0;
  for (const auto& face : mesh.face) sum += (face.cP(0) - centre) * ((face.cP(1) - centre) ^ (face.cP(2) - centre));
  return sum / 6;
}

void measure_volume(const Mesh& result, const Mesh& reference, Measurement& figures) {
  vcg::Box3d box;
  for (const auto& vertex : reference.vert) box.Add(vertex.cP());
  const double before = volume_about(reference, box.Center()), after = volume_about(result, box.Center());
  if (std::abs(before) > 1e-12 * std::pow(box.Diag(), 3))
    figures.volume_change_percent = 100 * (after - before) / std::abs(before);
}

/// RMS of what the displacement from `start` to `end` has across the vertex normals of `start`.
double tangential_rms(const Mesh& end, const Mesh& start) {
  const std::vector<vcg::Point3d> normals = vertex_normals(start);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i].SquaredNorm() == 0) continue;
    const vcg::Point3d move = end.vert[i].cP() - start.vert[i].cP();
    sum += (move - normals[i] * (move * normals[i])).SquaredNorm();
    ++count;
  }
  return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
}

}  // namespace

Measurement measure(const Mesh& result, const Mesh& reference, const Mesh* noisy, int threads) {
  check(reference, "reference");
  check(result, "result");
  check_same(result, "result", reference);
  if (noisy) {
    check(*noisy, "noisy");
    check_same(*noisy, "noisy", reference);
  }
  Measurement figures;
  figures.vertices = reference.vert.size();
  figures.faces = reference.face.size();
  const double e = figures.average_edge_length = average_edge_length(reference);
  if (!(e > 0)) throw std::invalid_argument("all vertices of the reference mesh lie at one place");
  measure_normals(result, reference, figures);
  measure_distance(result, reference, threads, figures.distance_rms, figures.distance_max);
  measure_distance(reference, result, threads, figures.reverse_distance_rms, figures.reverse_distance_max);
  for (double* length :
       {&figures.distance_rms, &figures.distance_max, &figures.reverse_distance_rms, &figures.reverse_distance_max})
    *length /= e;
  measure_volume(result, reference, figures);
  figures.true_tangential_drift = tangential_rms(result, reference) / e;
  if (noisy) figures.tangential_drift = tangential_rms(result, *noisy) / e;
  return figures;
}

}  // namespace mesh_tools
