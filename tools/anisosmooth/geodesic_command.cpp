// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include <vcg_core/distance_colors.h>
#include <vcg_core/geodesic_distance.h>

#include "command.h"
#include "interrupt.h"
#include "mesh_output.h"
#include "progress_bar.h"

namespace anisosmooth {
namespace {

struct Options {
  std::string input, output;
  long long start_vertex = 0;
  int isolines = 10;
  bool quiet = false;
};

void check_output(const std::string& path) {
  if (mesh_tools::extension(path) != ".ply")
    throw BadValue(path + ": distances are vertex quality, which only .ply can hold");
  mesh_tools::check_writable(path);
}

void run(const Options& options) {
  check_output(options.output);
  if (options.isolines < 0)
    throw BadValue("isolines is " + std::to_string(options.isolines) + "; it must be 0 or more");
  mesh_tools::MeshFile file = read_input(options.input);
  mesh_tools::Mesh& mesh = file.mesh;
  if (options.start_vertex < 0 || options.start_vertex >= mesh.vn)
    throw BadValue("start_vertex is " + std::to_string(options.start_vertex) + "; allowed are 0 to " +
                   std::to_string(mesh.vn - 1));
  std::vector<double> distance;
  {
    const CooperativeInterrupt scope;
    ProgressBar bar(options.quiet);
    distance = vcg_core::geodesic_distances(mesh, static_cast<std::size_t>(options.start_vertex), bar.callback());
  }
  const std::vector<vcg_core::Rgb> colors = vcg_core::distance_colors(mesh, distance, options.isolines);
  const bool in_floats = file.precision == mesh_tools::Precision::single_precision;
  double largest = 0;
  std::size_t unreached = 0;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    auto& vertex = mesh.vert[i];
    vertex.Q() = in_floats ? vcg_core::distance_quality<float>(distance[i]) : vcg_core::distance_quality(distance[i]);
    vertex.C() = vcg::Color4b(colors[i].red, colors[i].green, colors[i].blue, 255);
    if (std::isfinite(distance[i]))
      largest = std::max(largest, distance[i]);
    else
      ++unreached;
  }
  file.attributes |= mesh_tools::vertex_quality_attribute | mesh_tools::vertex_color_attribute;
  write_result(file, options.output);
  if (options.quiet) return;
  std::cout << "geodesic distances from vertex " << options.start_vertex << ": largest " << largest << "\n";
  if (unreached > 0) std::cout << unreached << " vertices are not connected with it; their quality is -1\n";
  std::cout << "written to " << options.output << "\n";
}

}  // namespace

std::function<void()> declare_geodesic(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("IN", options->input, "Mesh: PLY, OBJ, OFF, STL, GLB or glTF")->required();
  app.add_option("OUT", options->output, "PLY file with the distance as vertex quality, as colour ramp and iso-lines")
      ->required();
  app.add_option("--start-vertex", options->start_vertex, "Index of the vertex to measure from, the first is 0")
      ->required();
  app.add_option("--isolines", options->isolines, "Number of iso-lines; >= 0")->capture_default_str();
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
