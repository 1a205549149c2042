// SPDX-License-Identifier: GPL-3.0-or-later
#include "smoothing_filter.h"

#include "dialog_parameters.h"

#include <vcg_core/smoothing.h>

#include <cmath>
#include <new>
#include <sstream>

namespace meshlab_plugin {

namespace {

using vcg_core::MethodInfo;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;

void log_report(const SmoothingReport& report, const Session& session) {
  std::ostringstream lengths;
  lengths << "average edge length " << report.average_edge_length;
  if (report.sigma_c_length > 0) {
    lengths << ", sigma_c " << report.sigma_c_length << ", sigma_s " << report.sigma_s_length << ", cut-off "
            << report.rho_length;
  }
  if (report.estimated_noise) lengths << ", estimated noise " << *report.estimated_noise;
  lengths << " (in the mesh's unit)";
  session.log(lengths.str());

  std::ostringstream vertices;
  vertices << "moved " << report.moved_vertices << " of " << report.vertices << " vertices; held fixed "
           << report.fixed_vertices << ", skipped " << report.skipped_vertices.total() << "; displacement at most "
           << report.max_displacement << ", RMS " << report.rms_displacement;
  session.log(vertices.str());

  std::ostringstream volume;
  volume << "volume " << report.volume_before << " before, " << report.volume_after << " after; "
         << report.flipped_faces << " of " << report.faces << " faces turned over";
  if (report.bounded_vertices > 0) volume << "; " << report.bounded_vertices << " vertices held back";
  session.log(volume.str());

  for (const std::string& sentence : report.warnings()) session.log("Warning: " + sentence);
}

Report to_map(const SmoothingReport& report) {
  // PyMeshLab hands on no integers but int; vcglib counts vertices in one.
  const auto count = [](std::size_t n) { return static_cast<int>(n); };
  Report map{{"average_edge_length", report.average_edge_length},
             {"sigma_c_length", report.sigma_c_length},
             {"sigma_s_length", report.sigma_s_length},
             {"rho_length", report.rho_length},
             {"vertices", count(report.vertices)},
             {"moved_vertices", count(report.moved_vertices)},
             {"fixed_vertices", count(report.fixed_vertices)},
             {"skipped_vertices", count(report.skipped_vertices.total())},
             {"skipped_vertices_isolated", count(report.skipped_vertices.isolated)},
             {"skipped_vertices_undefined_normal", count(report.skipped_vertices.undefined_normal)},
             {"skipped_vertices_empty_neighbourhood", count(report.skipped_vertices.empty_neighbourhood)},
             {"max_displacement", report.max_displacement},
             {"rms_displacement", report.rms_displacement},
             {"volume_before", report.volume_before},
             {"volume_after", report.volume_after},
             {"faces", count(report.faces)},
             {"flipped_faces", count(report.flipped_faces)},
             {"far_moved_vertices", count(report.far_moved_vertices)},
             {"beyond_ring_vertices", count(report.beyond_ring_vertices)},
             {"bounded_vertices", count(report.bounded_vertices)},
             {"approximate_neighbourhoods", count(report.approximate_neighbourhoods)}};
  if (report.estimated_noise) map["estimated_noise"] = *report.estimated_noise;
  return map;
}

/// Normals that are no numbers become zero, as those of faces without area are: MeshLab's own computation of them
/// leaves the range of single precision when coordinates are about 1e19 or more.
template <class Elements>
void clear_undefined_normals(Elements& elements) {
  for (auto& element : elements) {
    if (element.IsD() || std::isfinite(element.cN().SquaredNorm())) continue;
    element.N().SetZero();
  }
}

Report apply(const MethodInfo& method, MeshModel& mesh, const RichParameterList& values, const Session& session) {
  const SmoothingReport report =
      vcg_core::smooth(mesh.cm, method.method, read_values(method, values), session.progress);
  update_box_and_normals(mesh, 0);
  clear_undefined_normals(mesh.cm.vert);
  clear_undefined_normals(mesh.cm.face);
  // The mesh has changed. Without memory for words the filter has still done its work, and must not say otherwise.
  try {
    log_report(report, session);
    return to_map(report);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

}  // namespace

Filter smoothing_filter(vcg_core::Method method, const char* name, const char* python_name, const char* help) {
  constexpr int geometry = MeshModel::MM_VERTCOORD | MeshModel::MM_VERTNORMAL | MeshModel::MM_FACENORMAL;
  constexpr int attributes = MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY;
  const MethodInfo& info = vcg_core::method_info(method);
  return {name,
          python_name,
          help,
          HostInterface::Smoothing,
          geometry | (info.uses(&SmoothingParameters::smooth_color) ? attributes : 0),
          [&info](const RichParameterList& values) {
            return geometry | (read_values(info, values).smooth_color ? attributes : 0);
          },
          [&info](const MeshModel* mesh) { return to_list(info, mesh); },
          [&info](MeshModel& mesh, const RichParameterList& values, const Session& session) {
            return apply(info, mesh, values, session);
          }};
}

}  // namespace meshlab_plugin
