// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include <json_figures/json_figures.h>
#include <mesh_tools/measure.h>
#include <vcg_core/mesh/measures.h>

#include "command.h"
#include "file_view.h"
#include "mesh_output.h"

namespace anisosmooth {
namespace {

struct Options {
  std::string result, reference, noisy;
  bool json = false;
  bool check = false;
};

void print_table(const mesh_tools::Measurement& figures, std::optional<std::size_t> self_intersections) {
  const auto angles = [](const char* name, const mesh_tools::AngleStatistics& angle) {
    std::printf("%-44s mean %8.3f   median %8.3f   95 %% below %8.3f   (%zu faces)\n", name, angle.mean, angle.median,
                angle.percentile_95, angle.faces);
  };
  const auto lengths = [](const char* name, double rms, double max) {
    std::printf("%-44s rms  %8.5f   max    %8.5f\n", name, rms, max);
  };
  std::printf("vertices %zu, faces %zu, average edge length e = %g\n", figures.vertices, figures.faces,
              figures.average_edge_length);
  angles("face normal error, degrees", figures.normal_error);
  angles("  at sharp edges (over 30 degrees)", figures.sharp_normal_error);
  lengths("distance to the reference surface, e", figures.distance_rms, figures.distance_max);
  lengths("distance from the reference's vertices, e", figures.reverse_distance_rms, figures.reverse_distance_max);
  if (figures.volume_change_percent)
    std::printf("%-44s %13.4f\n", "volume change, %", *figures.volume_change_percent);
  else
    std::printf("%-44s %13s\n", "volume change, %", "no volume");
  std::printf("%-44s %13zu\n", "flipped faces", figures.flipped_faces);
  if (self_intersections) std::printf("%-44s %13zu\n", "faces that cut through others", *self_intersections);
  if (figures.degenerate_faces > 0) std::printf("%-44s %13zu\n", "faces without area", figures.degenerate_faces);
  std::printf("%-44s rms  %8.5f\n", "tangential drift from the reference, e", figures.true_tangential_drift);
  if (figures.tangential_drift)
    std::printf("%-44s rms  %8.5f\n", "tangential drift from the noisy mesh, e", *figures.tangential_drift);
}

/// In the precision of the file, which bounds what counts as a cut.
std::size_t count_self_intersections(const mesh_tools::MeshFile& file) {
  mesh_tools::FlatFile flat = mesh_tools::to_flat(file);
  return vcg_core::count_self_intersections(FileView(flat).view());
}

void run(const Options& options) {
  const mesh_tools::MeshFile result = read_input(options.result);
  const mesh_tools::MeshFile reference = read_input(options.reference);
  std::optional<mesh_tools::MeshFile> noisy;
  if (!options.noisy.empty()) noisy.emplace(read_input(options.noisy));
  const mesh_tools::Measurement figures =
      mesh_tools::measure(result.mesh, reference.mesh, noisy ? &noisy->mesh : nullptr);
  std::optional<std::size_t> self_intersections;
  if (options.check) self_intersections = count_self_intersections(result);
  if (!options.json) return print_table(figures, self_intersections);
  nlohmann::ordered_json json = to_json(figures);
  if (self_intersections) json["self_intersections"] = *self_intersections;
  std::cout << json.dump(2) << "\n";
}

}  // namespace

std::function<void()> declare_measure(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("RESULT", options->result, "Smoothed mesh")->required();
  app.add_option("REFERENCE", options->reference,
                 "The truth: a mesh with the same vertices and faces, in the same order")
      ->required();
  app.add_option("--noisy", options->noisy, "The mesh before smoothing: also print how far vertices slid along it");
  app.add_flag("--check", options->check, "Also count the faces of RESULT that cut through others");
  app.add_flag("--json", options->json, "Print JSON");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
