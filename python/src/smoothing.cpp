// SPDX-License-Identifier: GPL-3.0-or-later
#include "smoothing.h"

#include <optional>
#include <string>
#include <vector>

#include <json_figures/json_figures.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/smoothing.h>

#include "arrays.h"
#include "catalogue.h"
#include "long_work.h"

namespace anisosmooth_python {

namespace nb = nanobind;
using namespace nb::literals;

namespace {

/// @param passed_over  a byte for each vertex, not zero if the mesh is to be taken as if it were not there
vcg_core::MeshView view_without(const ReadOnlyArray& positions, const ReadOnlyArray& faces,
                                const std::optional<ReadOnlyArray>& passed_over) {
  vcg_core::MeshView mesh = view_of(positions, faces);
  if (passed_over) {
    mesh.deleted_vertices.data = passed_over->data();
    mesh.deleted_vertices.stride = row_stride(*passed_over);
  }
  return mesh;
}

/// Smooths `positions`, and `colors` and `scalars` where smooth_color is set, in place.
std::string smooth(const Array& positions, const ReadOnlyArray& faces, const std::string& method_name,
                   const nb::dict& given, const std::optional<ReadOnlyArray>& passed_over,
                   const std::optional<ReadOnlyArray>& selected, const std::optional<ReadOnlyArray>& weights,
                   const std::optional<ReadOnlyArray>& creases, const std::optional<Array>& colors,
                   const std::optional<Array>& scalars, double weld_distance, double max_displacement, int threads,
                   bool check, nb::object progress) {
  const vcg_core::MethodInfo& method = vcg_core::method_info(method_name);
  vcg_core::SmoothingParameters parameters = parameters_of(method, given);
  parameters.threads = threads;
  parameters.check = check;
  vcg_core::MeshView mesh = view_without(ReadOnlyArray(positions), faces, passed_over);
  if (selected) {
    parameters.selected_only = true;
    mesh.selected_vertices.data = selected->data();
    mesh.selected_vertices.stride = row_stride(*selected);
  }
  if (weights) mesh.weights = real_rows(*weights);
  if (creases) {
    mesh.creases = index_rows(*creases);
    mesh.crease_count = creases->shape(0);
  }
  if (colors) mesh.colors = {static_cast<std::uint8_t*>(colors->data()), row_stride(*colors)};
  if (scalars) mesh.scalars = real_rows(ReadOnlyArray(*scalars));
  const vcg_core::SmoothingLimits limits{weld_distance, max_displacement};
  const vcg_core::SmoothingReport report = run(std::move(progress), [&](const vcg_core::Progress& callback) {
    return vcg_core::smooth(mesh, method.method, parameters, callback, limits);
  });
  return anisosmooth::to_json(report).dump();
}

nb::object distance(const ReadOnlyArray& positions, const ReadOnlyArray& faces,
                    const std::optional<ReadOnlyArray>& passed_over, std::size_t source, nb::object progress) {
  const vcg_core::MeshView mesh = view_without(positions, faces, passed_over);
  return to_array(run(std::move(progress), [&](const vcg_core::Progress& callback) {
    return vcg_core::geodesic_distances(mesh, source, callback);
  }));
}

double estimate_noise(const ReadOnlyArray& positions, const ReadOnlyArray& faces,
                      const std::optional<ReadOnlyArray>& passed_over, int threads, nb::object progress) {
  const vcg_core::MeshView mesh = view_without(positions, faces, passed_over);
  return run(std::move(progress),
             [&](const vcg_core::Progress& callback) { return vcg_core::estimate_noise(mesh, callback, threads); });
}

}  // namespace

void declare_smoothing(nb::module_& module) {
  module.def("catalogue", &catalogue);
  module.def("smooth", &smooth, "positions"_a, "faces"_a, "method"_a, "parameters"_a, "passed_over"_a.none(),
             "selected"_a.none(), "weights"_a.none(), "creases"_a.none(), "colors"_a.none(), "scalars"_a.none(),
             "weld_distance"_a, "max_displacement"_a, "threads"_a, "check"_a, "progress"_a.none());
  module.def("distance", &distance, "positions"_a, "faces"_a, "passed_over"_a.none(), "source"_a, "progress"_a.none());
  module.def("estimate_noise", &estimate_noise, "positions"_a, "faces"_a, "passed_over"_a.none(), "threads"_a,
             "progress"_a.none());
}

}  // namespace anisosmooth_python
