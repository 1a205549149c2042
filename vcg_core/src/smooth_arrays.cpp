// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_arrays.h"

#include <cmath>
#include <string>
#include <utility>

#include <vcg_core/errors.h>

#include "count_intersections.h"
#include "filters/catalogue.h"
#include "held_vertices.h"
#include "hold_back.h"
#include "job.h"
#include "mesh/near_borders.h"
#include "result_check.h"
#include "vertex_normals.h"
#include "volume.h"

namespace vcg_core::detail {

namespace {

/// Which vertices may move; counts why the others may not.
Array<std::uint8_t> find_movable(const MeshArrays& mesh, const SmoothingParameters& parameters, SmoothingReport& report,
                                 Job& job) {
  Array<std::uint8_t> movable(mesh.size());
  job.serial(mesh.size(), [&](std::size_t i) {
    const bool held = is_held(mesh, parameters, i);
    const bool isolated = is_isolated(mesh, i);
    if (held) report.fixed_vertices += mesh.counted(i);
    if (!held && isolated) report.skipped_vertices.isolated += mesh.counted(i);
    movable[i] = !held && !isolated;
  });
  return movable;
}

void describe_mesh(const MeshArrays& mesh, const MethodInfo& method, const SmoothingParameters& parameters,
                   SmoothingReport& report, Job& job) {
  const double e = std::ldexp(mesh.topology.average_edge_length, -mesh.exponent);
  report.average_edge_length = e;
  if (method.uses(&SmoothingParameters::sigma_c)) report.sigma_c_length = parameters.sigma_c * e;
  if (method.uses(&SmoothingParameters::sigma_s)) report.sigma_s_length = parameters.sigma_s * e;
  if (method.uses(&SmoothingParameters::rho)) report.rho_length = parameters.rho * parameters.sigma_c * e;
  report.vertices = mesh.counted_vertices();
  report.border_vertices = mesh.topology.border_vertices;
  report.non_manifold_vertices = mesh.topology.non_manifold_vertices;
  report.coincident_vertices = mesh.coincident_vertices;
  report.degenerate_faces = mesh.topology.degenerate_faces;
  report.crease_edges = mesh.topology.crease_edges;
  const NearBorders near_borders = find_near_borders(mesh, job);
  report.nearly_coincident_vertices = near_borders.vertices;
  report.nearly_coincident_distance = std::ldexp(near_borders.distance, -mesh.exponent);
}

void count_undefined_normals(const MeshArrays& mesh, const Array<Vec3>& normal, const Array<std::uint8_t>& movable,
                             SmoothingReport& report, Job& job) {
  job.serial(mesh.size(), [&](std::size_t i) {
    if (movable[i] && normal[i].isZero(0)) report.skipped_vertices.undefined_normal += mesh.counted(i);
  });
}

/// Adds the marks of one pass to those of all.
void add_marks(const Array<std::uint8_t>& marks, Array<std::uint8_t>& all, Job& job) {
  if (marks.empty()) return;
  all.resize(marks.size(), 0);
  job.serial(marks.size(), [&](std::size_t v) { all[v] |= marks[v]; });
}

}  // namespace

bool smooths_attributes(Method method, const SmoothingParameters& parameters) {
  return parameters.smooth_color && filter_of(method).smooth_attributes != nullptr;
}

SmoothingResult smooth_arrays(const MeshArrays& mesh, Method method, const SmoothingParameters& parameters,
                              const SmoothingLimits& limits, VertexAttributes& attributes, Job& job) {
  const Filter& filter = filter_of(method);
  if (!(mesh.topology.average_edge_length > 0)) throw InvalidMesh("the mesh has no edge of any length");
  SmoothingResult result;
  describe_mesh(mesh, filter.info, parameters, result.report, job);
  const Array<std::uint8_t> movable = find_movable(mesh, parameters, result.report, job);

  FilterPass run_pass = filter.make_pass(parameters);
  Array<std::uint8_t> bounded;
  const int passes = filter.one_pass ? 1 : parameters.iterations;
  for (int pass = 0; pass < passes; ++pass) {
    job.begin_stage("Smoothing", 0.05 + ((parameters.check ? 0.7 : 0.99) - 0.05) * (pass + 1) / passes);
    const Array<Vec3>& before = pass == 0 ? mesh.position : result.position;
    Array<Vec3> normal;
    if (filter.needs_normals) normal = vertex_normals(mesh, before, job);
    if (filter.needs_normals && pass == 0) count_undefined_normals(mesh, normal, movable, result.report, job);
    PassOutput output = run_pass({mesh, before, normal, movable, job});
    if (pass == 0) result.report.skipped_vertices.empty_neighbourhood = output.empty_neighbourhoods;
    result.report.approximate_neighbourhoods += output.approximate_neighbourhoods;
    if (output.estimated_noise) result.report.estimated_noise = std::ldexp(*output.estimated_noise, -mesh.exponent);
    for (std::string& note : output.notes) result.report.notes.push_back(std::move(note));
    hold_back(mesh, before, limits, output, job);
    add_marks(output.bounded, bounded, job);
    result.position = std::move(output.position);
  }
  run_pass = nullptr;  // and what it kept from pass to pass
  for (std::size_t v = 0; v < bounded.size(); ++v)
    if (bounded[v]) result.report.bounded_vertices += mesh.counted(v);

  if (attributes.channels() > 0) filter.smooth_attributes(mesh, result.position, movable, parameters, attributes, job);

  round_as_stored(mesh, result.position, job);
  check_result(mesh, result.position, result.report, job);
  result.report.advice = filter.advice;
  if (parameters.check) {
    job.begin_stage("Looking for self-intersections", 0.99);
    result.report.self_intersections = count_self_intersections(mesh, result.position, job);
  }
  result.report.volume_before = volume_over_center(mesh, mesh.position, job);
  result.report.volume_after = volume_over_center(mesh, result.position, job);
  return result;
}

}  // namespace vcg_core::detail
