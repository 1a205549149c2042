// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <utility>

#include <mesh_tools/noise.h>

#include "command.h"
#include "mesh_output.h"

namespace anisosmooth {
namespace {

struct Options {
  std::string input, output, direction = "normal";
  double level = 0;
  std::uint64_t seed = 1;
  bool quiet = false;
};

void run(const Options& options) {
  if (!(options.level >= 0) || !std::isfinite(options.level))
    throw BadValue("level is " + std::to_string(options.level) + "; it must be a finite number, 0 or more");
  if (options.direction != "normal" && options.direction != "any")
    throw BadValue("direction is '" + options.direction + "'; allowed are normal and any");
  const auto direction =
      options.direction == "any" ? mesh_tools::NoiseDirection::any : mesh_tools::NoiseDirection::normal;
  mesh_tools::check_writable(options.output, options.input);
  mesh_tools::OriginalFile original;
  mesh_tools::MeshFile file = read_input(options.input, &original);
  mesh_tools::add_noise(file.mesh, options.level, options.seed, direction);
  write_moved_result(file, std::move(original), options.output);
  if (!options.quiet)
    std::cout << "noise of " << options.level << " average edge lengths on " << file.mesh.vn << " vertices, written to "
              << options.output << "\n";
}

}  // namespace

std::function<void()> declare_noise(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("IN", options->input, "Mesh: PLY, OBJ, OFF, STL, GLB or glTF")->required();
  app.add_option("OUT", options->output, "Where the result goes")->required();
  app.add_option("--level", options->level,
                 "Standard deviation of the length of each vertex's move, in average edge lengths; >= 0")
      ->required();
  app.add_option("--seed", options->seed, "The same seed gives the same noise")->capture_default_str();
  app.add_option("--direction", options->direction,
                 "normal: along the vertex normal; any: along a random direction, uniform on the sphere")
      ->capture_default_str();
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
