// SPDX-License-Identifier: GPL-3.0-or-later
// Any mesh, any parameters: the documented error with the mesh bit for bit as it was, or a finite result of which the
// report tells the truth, the same for every number of threads.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include <support/mesh_types.h>
#include <support/raw_snapshot.h>
#include <vcg_core/distance_colors.h>
#include <vcg_core/geodesic_distance.h>
#include <vcg_core/smoothing.h>

#include "core_case.h"
#include "require.h"

namespace {

using fuzz::CoreCase;

enum class Outcome { smoothed, refused, cancelled };

template <class Mesh>
Outcome smooth(Mesh& mesh, const CoreCase& input, int threads, vcg_core::SmoothingReport& report) {
  vcg_core::SmoothingParameters parameters = input.parameters;
  parameters.threads = threads;
  int calls = 0;
  double last = 0;
  const auto progress = [&](double fraction, const char* stage) {
    FUZZ_REQUIRE(fraction >= last && fraction <= 1 && stage != nullptr);
    last = fraction;
    return ++calls != input.cancel_at;
  };
  try {
    report = vcg_core::smooth(mesh, input.method, parameters, progress);
    return Outcome::smoothed;
  } catch (const vcg_core::Cancelled&) {
    return Outcome::cancelled;
  } catch (const vcg_core::Error&) {
    return Outcome::refused;
  }
}

/// For each vertex the first one at exactly its place.
template <class Mesh>
std::vector<std::size_t> first_copies(const Mesh& mesh) {
  std::map<std::array<double, 3>, std::size_t> first;
  std::vector<std::size_t> result(mesh.vert.size());
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    if (mesh.vert[v].IsD()) continue;
    const auto& p = mesh.vert[v].cP();
    result[v] = first.emplace(std::array<double, 3>{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0}, v).first->second;
  }
  return result;
}

template <class Mesh>
std::vector<bool> held_vertices(const Mesh& mesh, const vcg_core::SmoothingParameters& parameters) {
  const std::vector<std::size_t> copy = first_copies(mesh);
  std::vector<bool> held(mesh.vert.size(), parameters.selected_only);
  std::map<std::pair<std::size_t, std::size_t>, int> faces_of_edge;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v)
    if (!mesh.vert[v].IsD() && mesh.vert[v].IsS()) held[copy[v]] = false;
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    std::size_t corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = copy[vcg::tri::Index(mesh, face.cV(k))];
    if (face.IsS())
      for (const std::size_t v : corner) held[v] = false;
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (int k = 0; k < 3; ++k) ++faces_of_edge[std::minmax(corner[k], corner[(k + 1) % 3])];
  }
  if (parameters.boundary == vcg_core::Boundary::fixed)
    for (const auto& [edge, faces] : faces_of_edge)
      if (faces == 1) held[edge.first] = held[edge.second] = true;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v)
    if (!mesh.vert[v].IsD()) held[v] = held[copy[v]];
  return held;
}

void require_finite(const vcg_core::SmoothingReport& report) {
  for (const double value : {report.average_edge_length, report.max_displacement, report.rms_displacement})
    FUZZ_REQUIRE(std::isfinite(value) && value >= 0);
  FUZZ_REQUIRE(report.rms_displacement <= report.max_displacement * (1 + 1e-12));
}

template <class Point>
bool same_bits(const Point& a, const Point& b) {
  return std::memcmp(a.V(), b.V(), 3 * sizeof a[0]) == 0;
}

template <class Mesh>
void check_result(const Mesh& before, const Mesh& after, const CoreCase& input,
                  const vcg_core::SmoothingReport& report) {
  const std::vector<bool> held = held_vertices(before, input.parameters);
  std::size_t moved = 0, present = 0, fixed = 0;
  for (std::size_t v = 0; v < after.vert.size(); ++v) {
    const auto from = before.vert[v].cP(), to = after.vert[v].cP();
    if (after.vert[v].IsD()) {
      FUZZ_REQUIRE(same_bits(from, to));
      continue;
    }
    FUZZ_REQUIRE(std::isfinite(to[0]) && std::isfinite(to[1]) && std::isfinite(to[2]));
    if (held[v]) FUZZ_REQUIRE(from == to);
    ++present;
    moved += from != to;
    fixed += held[v];
  }
  FUZZ_REQUIRE(report.vertices == present);
  FUZZ_REQUIRE(report.moved_vertices == moved);
  FUZZ_REQUIRE(report.fixed_vertices == fixed);
  FUZZ_REQUIRE(report.moved_vertices + report.fixed_vertices <= report.vertices);
  require_finite(report);
}

template <class Mesh>
void check_smoothing(const CoreCase& input) {
  Mesh before, mesh, again;
  for (Mesh* copy : {&before, &mesh, &again}) fill(*copy, input);
  const test_support::RawSnapshot<Mesh> snapshot(mesh);
  vcg_core::SmoothingReport report, other;
  const Outcome outcome = smooth(mesh, input, 1, report);
  if (outcome != Outcome::smoothed) {
    FUZZ_REQUIRE(snapshot.unchanged());
    return;
  }
  check_result(before, mesh, input, report);
  if (smooth(again, input, 3, other) == Outcome::cancelled) return;  // a slower run has more calls
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    FUZZ_REQUIRE(same_bits(mesh.vert[v].cP(), again.vert[v].cP()));
    FUZZ_REQUIRE(mesh.vert[v].cC() == again.vert[v].cC());
  }
  FUZZ_REQUIRE(report.moved_vertices == other.moved_vertices && report.rms_displacement == other.rms_displacement);
}

template <class Mesh>
void check_distances(const CoreCase& input) {
  Mesh mesh;
  fill(mesh, input);
  const test_support::RawSnapshot<Mesh> snapshot(mesh);
  try {
    const std::vector<double> distance = vcg_core::geodesic_distances(mesh, input.cancel_at);
    FUZZ_REQUIRE(distance.size() == mesh.vert.size() && distance[input.cancel_at] == 0);
    for (const double d : distance) FUZZ_REQUIRE(d >= 0);
    FUZZ_REQUIRE(vcg_core::distance_colors(mesh, distance, input.parameters.iterations + 3).size() == distance.size());
  } catch (const vcg_core::Error&) {
  }
  FUZZ_REQUIRE(snapshot.unchanged());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const CoreCase input = CoreCase::decode(data, size);
  if (input.double_precision) {
    check_smoothing<test_support::RichMesh>(input);
    check_distances<test_support::RichMesh>(input);
  } else {
    check_smoothing<test_support::OcfMesh>(input);
    check_distances<test_support::OcfMesh>(input);
  }
  return 0;
}
