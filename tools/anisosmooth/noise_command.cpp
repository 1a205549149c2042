// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <mesh_tools/noise.h>

#include "command.h"
#include "mesh_output.h"

namespace anisosmooth {
namespace {

struct Options {
  std::string input, output, direction = "normal";
  std::vector<double> camera, axis;
  mesh_tools::NoiseModel model;
  CLI::Option* direction_option = nullptr;
  bool quiet = false;
};

mesh_tools::NoiseModel model_of(const Options& options) {
  mesh_tools::NoiseModel model = options.model;
  if (!(model.level >= 0) || !std::isfinite(model.level))
    throw BadValue("level is " + std::to_string(model.level) + "; it must be a finite number, 0 or more");
  if (options.direction != "normal" && options.direction != "any")
    throw BadValue("direction is '" + options.direction + "'; allowed are normal and any");
  if (options.direction == "any") model.direction = mesh_tools::NoiseDirection::any;
  const auto point = [](const std::vector<double>& p) { return vcg::Point3d(p[0], p[1], p[2]); };
  if (!options.axis.empty()) model.axis = point(options.axis);
  if (options.camera.empty()) return model;
  if (options.direction_option->count() > 0)
    throw BadValue("direction and camera are both given; a camera's noise is along its rays");
  model.camera = point(options.camera);
  return model;
}

void run(const Options& options) {
  const mesh_tools::NoiseModel model = model_of(options);
  mesh_tools::check_writable(options.output, options.input);
  mesh_tools::OriginalFile original;
  mesh_tools::MeshFile file = read_input(options.input, &original);
  mesh_tools::add_noise(file.mesh, model);
  write_moved_result(file, std::move(original), options.output);
  if (!options.quiet)
    std::cout << "noise of " << model.level << " average edge lengths on " << file.mesh.vn << " vertices, written to "
              << options.output << "\n";
}

}  // namespace

std::function<void()> declare_noise(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("IN", options->input, "Mesh: PLY, OBJ, OFF, STL, GLB or glTF")->required();
  app.add_option("OUT", options->output, "Where the result goes")->required();
  app.add_option("--level", options->model.level,
                 "Standard deviation of the length of each vertex's move, in average edge lengths; >= 0")
      ->required();
  app.add_option("--seed", options->model.seed, "The same seed gives the same noise")->capture_default_str();
  options->direction_option =
      app.add_option("--direction", options->direction,
                     "normal: along the vertex normal; any: along a random direction, uniform on the sphere")
          ->capture_default_str();
  app.add_option("--correlation", options->model.correlation,
                 "Distance along the surface at which the moves of two vertices have the correlation 1/e, in average "
                 "edge lengths; >= 0 [default 0: independent]");
  app.add_option("--share", options->model.share,
                 "Impulsive noise: the probability with which a vertex moves at all; above 0, at most 1 [default 1]");
  app.add_option("--level-far", options->model.level_far,
                 "Level at the end of the mesh in direction of the axis; it changes linearly from --level at the other "
                 "end; >= 0");
  app.add_option("--camera", options->camera,
                 "X,Y,Z: a depth camera there, in the mesh's unit. Vertices move along its rays, by the level at the "
                 "mean distance, more with the square of the distance and on slanted surfaces")
      ->delimiter(',')
      ->expected(3);
  app.add_option(
      "--step", options->model.step,
      "Round positions in direction of the axis to multiples of this, in average edge lengths; >= 0 [default "
      "0: not]");
  app.add_option("--axis", options->axis, "X,Y,Z: the direction of --level-far and --step [default 0,0,1]")
      ->delimiter(',')
      ->expected(3);
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
