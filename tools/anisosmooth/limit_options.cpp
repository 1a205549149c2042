// SPDX-License-Identifier: GPL-3.0-or-later
#include "limit_options.h"

#include <cmath>

#include <mesh_tools/ply_property.h>

namespace anisosmooth {

void declare_limits(CLI::App& app, vcg_core::SmoothingLimits& limits) {
  app.add_option("--weld-distance", limits.weld_distance,
                 "Take vertices up to this far apart for one, in the mesh's unit; they move as one and keep their "
                 "distances; >= 0 [default 0: those at exactly the same place]");
  app.add_option("--max-displacement", limits.max_displacement,
                 "Move no vertex farther than this, in the mesh's unit; >= 0 [default: no limit]");
}

void declare_limits(CLI::App& app, LimitOptions& options) {
  declare_limits(app, options.limits);
  app.add_option("--weights", options.weights,
                 "Vertex property of the PLY file IN that says how far each vertex follows the filter: from 0, it "
                 "stays, to 1. 'quality' is the vertices' quality, whatever its name in the file");
}

std::vector<double> weights_of(const LimitOptions& options, const mesh_tools::FlatFile& file,
                               const mesh_tools::SourceFile& source) {
  if (options.weights.empty()) return {};
  if (options.weights != "quality" || !(file.attributes & mesh_tools::vertex_quality_attribute))
    return mesh_tools::vertex_property({source.path(), source.read()}, options.weights);
  return file.mesh.vertex_quality;
}

void add_limits(const LimitOptions& options, nlohmann::ordered_json& json) {
  if (options.limits.weld_distance > 0) json["weld_distance"] = options.limits.weld_distance;
  if (std::isfinite(options.limits.max_displacement)) json["max_displacement"] = options.limits.max_displacement;
  if (!options.weights.empty()) json["weights"] = options.weights;
}

}  // namespace anisosmooth
