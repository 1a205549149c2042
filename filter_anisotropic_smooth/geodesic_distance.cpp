// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic_distance.h"

#include <vcg_core/distance_colors.h>
#include <vcg_core/errors.h>
#include <vcg_core/geodesic_distance.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace meshlab_plugin {

namespace {

constexpr char start_vertex_name[] = "start_vertex";
constexpr char isolines_name[] = "isolines";

/// The source as an index, checked here because a negative one would become a huge one.
std::size_t read_start_vertex(const MeshModel& mesh, const RichParameterList& values) {
  const int start = values.getInt(start_vertex_name);
  const std::size_t size = mesh.cm.vert.size();
  if (start < 0 || static_cast<std::size_t>(start) >= size) {
    throw vcg_core::InvalidParameter(
        std::string(start_vertex_name) + " is " + std::to_string(start) + "; it must be " +
        (size == 0 ? "a vertex, and the mesh has none" : "from 0 to " + std::to_string(size - 1)));
  }
  return static_cast<std::size_t>(start);
}

void write(const std::vector<double>& distance, const std::vector<vcg_core::Rgb>& colors, MeshModel& mesh) {
  mesh.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    auto& vertex = mesh.cm.vert[v];
    if (vertex.IsD()) continue;
    using Quality = std::decay_t<decltype(vertex.Q())>;
    vertex.Q() = vcg_core::distance_quality<Quality>(distance[v]);
    vertex.C() = vcg::Color4b(colors[v].red, colors[v].green, colors[v].blue, 255);
  }
}

RichParameterList parameters(const MeshModel* mesh) {
  const std::size_t size = mesh != nullptr ? mesh->cm.vert.size() : 0;
  RichParameterList list;
  list.addParam(RichInt(start_vertex_name, 0, "Start vertex",
                        QString("Index of the vertex from which distances are measured. A higher index only means"
                                " another vertex. 0 or more%1. No unit.")
                            .arg(size > 0 ? QString(", here up to %1").arg(size - 1) : QString())));
  list.addParam(RichInt(isolines_name, 10, "Number of lines",
                        "How many dark lines of equal distance are drawn between the start and the farthest vertex."
                        " Higher: lines lie closer together. 0 (none) or more. No unit."));
  return list;
}

Report apply(MeshModel& mesh, const RichParameterList& values, const Session& session) {
  const int isolines = values.getInt(isolines_name);
  if (isolines < 0) {
    throw vcg_core::InvalidParameter(std::string(isolines_name) + " is " + std::to_string(isolines) +
                                     "; it must be 0 or more");
  }
  const std::vector<double> distance =
      vcg_core::geodesic_distances(mesh.cm, read_start_vertex(mesh, values), session.progress);
  const std::vector<vcg_core::Rgb> colors = vcg_core::distance_colors(mesh.cm, distance, isolines);

  double largest = 0;
  std::size_t vertices = 0;
  std::size_t unreachable = 0;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (mesh.cm.vert[v].IsD()) continue;
    ++vertices;
    if (std::isfinite(distance[v])) {
      largest = std::max(largest, distance[v]);
    } else {
      ++unreachable;
    }
  }
  std::ostringstream line;
  line << "largest distance " << largest << " (in the mesh's unit); reached " << vertices - unreachable << " of "
       << vertices << " vertices";
  Report report{{"max_distance", largest},
                {"vertices", static_cast<int>(vertices)},
                {"unreachable_vertices", static_cast<int>(unreachable)}};
  session.log(line.str());
  if (unreachable > 0) {
    session.log("Warning: " + std::to_string(unreachable) +
                " vertices are not connected to the start vertex; their quality is -1 and they are grey");
  }
  write(distance, colors, mesh);  // last: nothing can fail once the mesh has changed
  return report;
}

}  // namespace

Filter geodesic_distance_filter() {
  constexpr int changes = MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR;
  return {"Geodesic Distance by Virtual Source",
          "compute_scalar_by_virtual_source_geodesic",
          "Computes how far each vertex is from a start vertex, measured along the surface, and stores it as vertex"
          " quality. Use it to measure along a scan, to see whether parts are connected, or to check the distances"
          " that <i>Anisotropic Feature-Preserving Smoothing</i> works with. Vertices are coloured from red (near) to"
          " blue (far), with dark lines of equal distance.<br>"
          "Vertices that no path of faces reaches get quality -1 and turn grey; the log counts them.<br>"
          "Distances are found by fast marching with a virtual start point in double precision: exact on a plane up"
          " to rounding, and a good approximation on curved surfaces.<br>"
          "See: <b>\"Anisotropic Feature-Preserving Smoothing of 3D Mesh\"</b>, section 4.1, figures 5 and 6.",
          HostInterface::Quality | HostInterface::VertexColoring,
          changes,
          [](const RichParameterList&) { return changes; },
          parameters,
          apply};
}

}  // namespace meshlab_plugin
