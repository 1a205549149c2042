// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <mesh_tools/large_torus.h>
#include <mesh_tools/shapes.h>
#include <mesh_tools/voxel_shapes.h>

#include "command.h"
#include "mesh_output.h"

namespace anisosmooth {
namespace {

constexpr long long most_vertices = 50'000'000;
constexpr long long most_vertices_of_torus = 1'000'000'000;  // its faces are twice as many, and 32 bits have to do

struct Options {
  std::string shape, output, truth;
  long long vertices = 10000;
  std::optional<double> slice_distance, tilt;
  bool double_precision = false, quiet = false;
};

/// The torus is the shape that can be of any size, as PLY.
bool is_streamed(const Options& options) {
  return options.shape == "torus" && mesh_tools::extension(options.output) == ".ply";
}

void print_done(const Options& options, std::size_t vertices, std::size_t faces) {
  if (!options.quiet)
    std::cout << options.shape << ": " << vertices << " vertices, " << faces << " faces, written to " << options.output
              << "\n";
}

void stream_torus(const Options& options) {
  const CooperativeInterrupt scope;
  const mesh_tools::LargeTorus torus = mesh_tools::write_large_torus(
      static_cast<std::size_t>(options.vertices), options.double_precision, options.output, interrupted);
  result_is_in_place();
  print_done(options, torus.vertices, torus.faces);
}

mesh_tools::MeshFile file_of(const Options& options, mesh_tools::Mesh mesh) {
  mesh_tools::MeshFile file;
  file.mesh = std::move(mesh);
  file.precision =
      options.double_precision ? mesh_tools::Precision::double_precision : mesh_tools::Precision::single_precision;
  return file;
}

void write_shape(const Options& options, mesh_tools::Mesh mesh) {
  const mesh_tools::MeshFile file = file_of(options, std::move(mesh));
  write_result(file, options.output);
  print_done(options, file.mesh.vert.size(), file.mesh.face.size());
}

void write_voxel_shape(const Options& options) {
  if (!options.truth.empty()) mesh_tools::check_writable(options.truth);
  if (options.truth == options.output) throw BadValue("truth and OUT are the same file");
  mesh_tools::VoxelGrid grid;
  grid.slice_distance = options.slice_distance.value_or(grid.slice_distance);
  grid.tilt = options.tilt.value_or(grid.tilt);
  mesh_tools::VoxelShape shape =
      mesh_tools::make_voxel_shape(options.shape, static_cast<std::size_t>(options.vertices), grid);
  if (!options.truth.empty()) write_output(file_of(options, std::move(shape.truth)), options.truth);
  write_shape(options, std::move(shape.surface));
}

void run(const Options& options) {
  const long long most = is_streamed(options) ? most_vertices_of_torus : most_vertices;
  if (options.vertices < 1 || options.vertices > most)
    throw BadValue("vertices is " + std::to_string(options.vertices) + "; allowed are 1 to " + std::to_string(most));
  mesh_tools::check_writable(options.output);
  if (mesh_tools::is_voxel_shape(options.shape)) return write_voxel_shape(options);
  if (!options.truth.empty() || options.slice_distance || options.tilt)
    throw BadValue("truth, slice-distance and tilt are for voxel shapes only; " + options.shape + " is not one");
  if (is_streamed(options)) return stream_torus(options);
  write_shape(options, mesh_tools::make_shape(options.shape, static_cast<std::size_t>(options.vertices)));
}

std::string shape_help() {
  std::string text = "One of";
  for (const mesh_tools::Shape& shape : mesh_tools::all_shapes())
    text += std::string("\n") + shape.name + ": " + shape.description;
  return text + "\nvoxel_ before a closed one of them, as in voxel_sphere: the surface of its voxels";
}

}  // namespace

std::function<void()> declare_generate(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("SHAPE", options->shape, shape_help())->required();
  app.add_option("OUT", options->output, "Where the mesh goes: PLY, OBJ, OFF or STL")->required();
  app.add_option("--vertices", options->vertices, "About how many; shapes with details have a least number")
      ->capture_default_str();
  app.add_option("--slice-distance", options->slice_distance,
                 "Voxel shapes: distance of the slices along z, in pixels; 1 to 6, 1 by default");
  app.add_option("--tilt", options->tilt,
                 "Voxel shapes: degrees by which the shape is turned against the voxels; 0 by default");
  app.add_option("--truth", options->truth,
                 "Voxel shapes: where the same faces go with their vertices on the shape itself, for measure");
  app.add_flag("--double", options->double_precision,
               "Write coordinates in double precision, not in float as most files");
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
