// SPDX-License-Identifier: GPL-3.0-or-later
// guided_variant IN OUT [NAME=VALUE...]: the guided filter with some of its constants changed or parts left out. The
// names are those of GuidedSettings; 0 leaves a part out. For scripts/guided_benchmark, which tells what each part
// brings.

#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

#include <job.h>
#include <mesh/commit_positions.h>
#include <mesh/read_mesh.h>
#include <mesh_tools/mesh_io.h>
#include <vcg_core/mesh/vcglib_view.h>
#include <vcg_core/method.h>

#include "filters/guided/guided_filter.h"
#include "filters/guided/guided_settings.h"

namespace {

using vcg_core::detail::GuidedSettings;

using Setter = std::function<void(GuidedSettings&, double)>;

template <class Value>
Setter set(Value GuidedSettings::*field) {
  return [field](GuidedSettings& settings, double value) { settings.*field = static_cast<Value>(value); };
}

const std::map<std::string, Setter>& setters() {
  static const std::map<std::string, Setter> all = {
      {"radius", set(&GuidedSettings::radius)},
      {"closeness", set(&GuidedSettings::closeness)},
      {"noise_spacing", set(&GuidedSettings::noise_spacing)},
      {"rounds_by_noise", set(&GuidedSettings::rounds_by_noise)},
      {"fewest_rounds", set(&GuidedSettings::fewest_rounds)},
      {"most_rounds", set(&GuidedSettings::most_rounds)},
      {"coarse_range", set(&GuidedSettings::coarse_range)},
      {"coarse_updates", set(&GuidedSettings::coarse_updates)},
      {"fine_rounds", set(&GuidedSettings::fine_rounds)},
      {"fine_range", set(&GuidedSettings::fine_range)},
      {"final_updates", set(&GuidedSettings::final_updates)},
      {"detail_from", set(&GuidedSettings::detail_from)},
      {"detail_full", set(&GuidedSettings::detail_full)},
      {"most_deviations", set(&GuidedSettings::most_deviations)},
      {"unfold_step", set(&GuidedSettings::unfold_step)},
      {"fold_cosine", set(&GuidedSettings::fold_cosine)},
      {"blend", set(&GuidedSettings::blend)},
      {"second_stage", set(&GuidedSettings::second_stage)},
      {"guide", set(&GuidedSettings::guide)},
      {"guard_thin_parts", set(&GuidedSettings::guard_thin_parts)},
      {"fine", set(&GuidedSettings::fine)},
      {"restart", set(&GuidedSettings::restart)},
      {"unfold", set(&GuidedSettings::unfold)},
      {"recover_detail", set(&GuidedSettings::recover_detail)},
      {"follow_edge_length", set(&GuidedSettings::follow_edge_length)},
  };
  return all;
}

void change(GuidedSettings& settings, const std::string& assignment) {
  const std::size_t sign = assignment.find('=');
  const auto setter = setters().find(assignment.substr(0, sign));
  if (sign == std::string::npos || setter == setters().end())
    throw std::invalid_argument("'" + assignment + "' is not NAME=VALUE with a name of GuidedSettings");
  setter->second(settings, std::stod(assignment.substr(sign + 1)));
}

void run(int argc, char** argv) {
  if (argc < 3) throw std::invalid_argument("usage: guided_variant IN OUT [NAME=VALUE...]");
  using namespace vcg_core::detail;
  mesh_tools::MeshFile file = mesh_tools::read_mesh(argv[1]);
  const vcg_core::SmoothingParameters parameters = vcg_core::method_info(vcg_core::Method::guided).defaults;
  GuidedSettings settings = guided_settings(parameters, parameters.iterations);
  for (int k = 3; k < argc; ++k) change(settings, argv[k]);
  const vcg_core::Progress silent;
  Job job(silent, 1);
  const MeshArrays mesh = read_mesh(vcg_core::view_of(file.mesh), job);
  job.begin_stage("Smoothing", 1);
  Array<std::uint8_t> movable(mesh.size());
  for (std::size_t v = 0; v < mesh.size(); ++v)
    movable[v] = mesh.topology.star_begin[v] < mesh.topology.star_begin[v + 1];
  const Array<Vec3> no_normals;
  const PassOutput output = guided_pass({mesh, mesh.position, no_normals, movable, job}, settings);
  vcg_core::SmoothingReport report;
  commit_positions(mesh, output.position, vcg_core::view_of(file.mesh), report);
  mesh_tools::write_mesh(file, argv[2]);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "guided_variant: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
