// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>

#include <mesh_tools/shapes.h>

#include "command.h"
#include "mesh_output.h"

namespace anisosmooth {
namespace {

constexpr long long most_vertices = 50'000'000;

struct Options {
  std::string shape, output;
  long long vertices = 10000;
  bool double_precision = false, quiet = false;
};

void run(const Options& options) {
  if (options.vertices < 1 || options.vertices > most_vertices)
    throw BadValue("vertices is " + std::to_string(options.vertices) + "; allowed are 1 to " +
                   std::to_string(most_vertices));
  mesh_tools::check_writable(options.output);
  mesh_tools::MeshFile file;
  file.mesh = mesh_tools::make_shape(options.shape, static_cast<std::size_t>(options.vertices));
  file.precision =
      options.double_precision ? mesh_tools::Precision::double_precision : mesh_tools::Precision::single_precision;
  write_result(file, options.output);
  if (!options.quiet)
    std::cout << options.shape << ": " << file.mesh.vn << " vertices, " << file.mesh.fn << " faces, written to "
              << options.output << "\n";
}

std::string shape_help() {
  std::string text = "One of";
  for (const mesh_tools::Shape& shape : mesh_tools::all_shapes())
    text += std::string("\n") + shape.name + ": " + shape.description;
  return text;
}

}  // namespace

std::function<void()> declare_generate(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("SHAPE", options->shape, shape_help())->required();
  app.add_option("OUT", options->output, "Where the mesh goes: PLY, OBJ, OFF or STL")->required();
  app.add_option("--vertices", options->vertices, "About how many; shapes with details have a least number")
      ->capture_default_str();
  app.add_flag("--double", options->double_precision,
               "Write coordinates in double precision, not in float as most files");
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
