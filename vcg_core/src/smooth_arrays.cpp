#include <vcg_core/detail/smooth_arrays.h>

#include <cmath>
#include <string>
#include <utility>

#include <vcg_core/detail/count_intersections.h>
#include <vcg_core/detail/job.h>

#include "copy_positions.h"
#include "filters/catalogue.h"
#include "result_check.h"
#include "vertex_normals.h"
#include "volume.h"

namespace vcg_core::detail {

namespace {

/// Which vertices may move; counts why the others may not.
Array<std::uint8_t> find_movable(const MeshArrays& mesh, const SmoothingParameters& parameters, SmoothingReport& report,
                                 Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<std::uint8_t> movable(mesh.size());
  job.serial(mesh.size(), [&](std::size_t i) {
    const bool held = (parameters.boundary == Boundary::fixed && topology.border[i]) ||
                      (parameters.selected_only && !mesh.selected[i]);
    const bool isolated = topology.star_begin[i] == topology.star_begin[i + 1];
    report.fixed_vertices += held;
    report.skipped_vertices.isolated += !held && isolated;
    movable[i] = !held && !isolated;
  });
  return movable;
}

void describe_mesh(const MeshArrays& mesh, const MethodInfo& method, const SmoothingParameters& parameters,
                   SmoothingReport& report) {
  const double e = std::ldexp(mesh.topology.average_edge_length, -mesh.exponent);
  report.average_edge_length = e;
  if (method.uses(&SmoothingParameters::sigma_c)) report.sigma_c_length = parameters.sigma_c * e;
  if (method.uses(&SmoothingParameters::sigma_s)) report.sigma_s_length = parameters.sigma_s * e;
  if (method.uses(&SmoothingParameters::rho)) report.rho_length = parameters.rho * parameters.sigma_c * e;
  report.vertices = mesh.size();
  report.border_vertices = mesh.topology.border_vertices;
  report.non_manifold_vertices = mesh.topology.non_manifold_vertices;
  report.coincident_vertices = mesh.coincident_vertices;
  report.degenerate_faces = mesh.topology.degenerate_faces;
}

void count_undefined_normals(const MeshArrays& mesh, const Array<Vec3>& normal, const Array<std::uint8_t>& movable,
                             SmoothingReport& report, Job& job) {
  job.serial(mesh.size(),
             [&](std::size_t i) { report.skipped_vertices.undefined_normal += movable[i] && normal[i].isZero(0); });
}

}  // namespace

bool smooths_attributes(Method method, const SmoothingParameters& parameters) {
  return parameters.smooth_color && filter_of(method).smooth_attributes != nullptr;
}

SmoothingResult smooth_arrays(const MeshArrays& mesh, Method method, const SmoothingParameters& parameters,
                              VertexAttributes& attributes, Job& job) {
  const Filter& filter = filter_of(method);
  SmoothingResult result;
  describe_mesh(mesh, filter.info, parameters, result.report);
  const Array<std::uint8_t> movable = find_movable(mesh, parameters, result.report, job);

  const FilterPass run_pass = filter.make_pass(parameters);
  result.position = copy_positions(mesh.position, job);
  const int passes = filter.one_pass ? 1 : parameters.iterations;
  for (int pass = 0; pass < passes; ++pass) {
    job.begin_stage("Smoothing", 0.05 + ((parameters.check ? 0.7 : 0.99) - 0.05) * (pass + 1) / passes);
    Array<Vec3> normal;
    if (filter.needs_normals) normal = vertex_normals(mesh, result.position, job);
    if (filter.needs_normals && pass == 0) count_undefined_normals(mesh, normal, movable, result.report, job);
    PassOutput output = run_pass({mesh, result.position, normal, movable, job});
    if (pass == 0) result.report.skipped_vertices.empty_neighbourhood = output.empty_neighbourhoods;
    result.report.approximate_neighbourhoods += output.approximate_neighbourhoods;
    result.report.bounded_vertices += output.bounded_vertices;
    if (output.estimated_noise) result.report.estimated_noise = std::ldexp(*output.estimated_noise, -mesh.exponent);
    for (std::string& note : output.notes) result.report.notes.push_back(std::move(note));
    result.position = std::move(output.position);
  }

  if (attributes.channels() > 0) filter.smooth_attributes(mesh, result.position, movable, parameters, attributes, job);

  round_as_stored(mesh, result.position, job);
  check_result(mesh, result.position, result.report, job);
  result.report.advice = filter.advice;
  if (parameters.check) {
    job.begin_stage("Looking for self-intersections", 0.99);
    result.report.self_intersections = count_self_intersections(mesh, result.position, job);
  }
  const Vec3 apex = bounding_box(mesh.position, job).center();  // the same one before and after
  const auto volume = [&](const Array<Vec3>& position) {
    return std::ldexp(signed_volume(mesh, position, apex, job), -3 * mesh.exponent);
  };
  result.report.volume_before = volume(mesh.position);
  result.report.volume_after = volume(result.position);
  return result;
}

}  // namespace vcg_core::detail
