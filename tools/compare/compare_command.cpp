// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <json_figures/json_figures.h>
#include <mesh_tools/mesh_io.h>

#include "command.h"
#include "comparison.h"
#include "comparison_text.h"
#include "interrupt.h"
#include "mesh_output.h"
#include "pictures.h"
#include "progress_bar.h"

namespace anisosmooth {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string noisy, reference, folder;
  std::vector<double> view;
  std::string up = "z";
  int threads = 0;
  bool quiet = false, no_pictures = false;
};

View chosen_view(const Options& options) {
  View view;
  if (options.up == "y") {
    view.up = vcg::Point3d(0, 1, 0);
    view.direction = vcg::Point3d(-0.8, 1, 1.5);
  } else if (options.up != "z") {
    throw BadValue("up is '" + options.up + "'; allowed are y and z");
  }
  if (!options.view.empty()) view.direction = vcg::Point3d(options.view[0], options.view[1], options.view[2]);
  if (!((view.direction ^ view.up).Norm() > 1e-6 * view.direction.Norm()))
    throw BadValue("view must be a direction that is not along the axis that points up");
  return view;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) throw BadValue(folder + ": cannot be made a folder for the results");
}

Comparison run_comparison(const Options& options) {
  mesh_tools::MeshFile noisy = read_input(options.noisy);
  std::optional<mesh_tools::MeshFile> reference;
  if (!options.reference.empty()) reference.emplace(read_input(options.reference));
  ProgressBar bar(options.quiet);
  return compare_methods(std::move(noisy), std::move(reference), options.threads, bar.callback());
}

/// Positions and faces only: with normals in the file a viewer would not shade it flat.
void write_results(Comparison& comparison, const fs::path& folder) {
  mesh_tools::MeshFile& file = comparison.noisy;
  const Positions before = positions_of(file.mesh);
  const int attributes = std::exchange(file.attributes, 0);
  for (const MethodRun& run : comparison.runs) {
    set_positions(file.mesh, run.positions);
    write_output(file, (folder / (run.method.name + ".ply")).string());
  }
  set_positions(file.mesh, before);
  file.attributes = attributes;
}

void write_reports(const Options& options, const Comparison& comparison, const Pictures& pictures,
                   const fs::path& folder) {
  nlohmann::ordered_json json = {{"noisy", options.noisy}};
  if (!options.reference.empty()) json["reference"] = options.reference;
  json.update(to_json(comparison));
  json["pictures"] = pictures.files;
  write_output(mesh_tools::TextFile{folder / "report.json", json_text(json)});
  const auto name = [](const std::string& path) { return fs::path(path).filename().string(); };
  write_output(mesh_tools::TextFile{
      folder / "report.md", to_markdown(comparison, name(options.noisy), name(options.reference), pictures.files)});
}

void print_summary(const Comparison& comparison, const std::string& folder) {
  const auto line = [](const std::string& title, const std::optional<mesh_tools::Measurement>& figures) {
    std::printf("%-44s", title.c_str());
    if (figures)
      std::printf(" normal error %6.2f, at sharp edges %6.2f degrees; distance %.3f e", figures->normal_error.mean,
                  figures->sharp_normal_error.mean, figures->distance_rms);
  };
  if (comparison.noisy_figures) {
    line("noisy", comparison.noisy_figures);
    std::printf("\n");
  }
  for (const MethodRun& run : comparison.runs) {
    line(run.method.title, run.figures);
    std::printf("; %.3f s\n", run.seconds);
  }
  std::printf("written to %s\n", folder.c_str());
}

void run(const Options& options) {
  const View view = chosen_view(options);
  Comparison comparison = run_comparison(options);
  make_folder(options.folder);
  const fs::path folder = options.folder;
  write_results(comparison, folder);
  Pictures pictures;
  if (!options.no_pictures) pictures = draw_pictures(comparison, view, folder);
  write_reports(options, comparison, pictures, folder);
  if (!pictures.problem.empty()) print_warnings({pictures.problem});
  if (!options.quiet) print_summary(comparison, options.folder);
}

}  // namespace

std::function<void()> declare_compare(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("NOISY", options->noisy, "Mesh to smooth: PLY, OBJ, OFF, STL, GLB or glTF")->required();
  app.add_option("REFERENCE", options->reference,
                 "The truth: a mesh with the same vertices and faces, in the same order; with it, errors are measured");
  app.add_option("--out", options->folder,
                 "Folder for the results, made if it is not there: a PLY for each method, report.json, report.md,"
                 " figure9.png, errors.png")
      ->required();
  app.add_option("--view", options->view, "Direction from the object to the camera, X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--up", options->up, "Axis that points up in the pictures: y or z")->capture_default_str();
  app.add_flag("--no-pictures", options->no_pictures, "Draw no pictures");
  app.add_option("--threads", options->threads, "Number of threads, 0 for one a processor; the result is the same")
      ->capture_default_str();
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
