// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <durable_files/replace_file.h>
#include <json_figures/json_figures.h>
#include <mesh_tools/mesh_io.h>
#include <tiles/tiles.h>
#include <vcg_core/method.h>

#include "command.h"
#include "hidden_vertices.h"
#include "interrupt.h"
#include "limit_options.h"
#include "many_files.h"
#include "memory_size.h"
#include "mesh_output.h"
#include "parameter_options.h"
#include "progress_bar.h"
#include "smooth_file.h"
#include "smooth_summary.h"

namespace anisosmooth {
namespace {

using nlohmann::ordered_json;
using vcg_core::MethodInfo;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;

struct Options {
  FileArguments files;
  std::string report;
  std::string method = "paper";
  ParameterOptions parameters;
  LimitOptions limits;
  std::string memory;
  bool quiet = false;
};

bool has_selection(const mesh_tools::FlatMesh& mesh) {
  const auto is_selected = [](std::int32_t flags) { return (flags & mesh_tools::selected_flag) != 0; };
  return std::any_of(mesh.vertex_flags.begin(), mesh.vertex_flags.end(), is_selected) ||
         std::any_of(mesh.face_flags.begin(), mesh.face_flags.end(), is_selected);
}

void check_report_path(const std::string& report, const std::vector<FilePair>& pairs) {
  if (report.empty()) return;
  namespace fs = std::filesystem;
  const auto place = [](const fs::path& path) {
    return fs::weakly_canonical(fs::absolute(durable_files::final_target(path)));
  };
  for (const FilePair& pair : pairs)
    for (const std::string& mesh : {pair.input, pair.output})
      for (const fs::path& file : mesh_tools::files_of(mesh))
        if (place(report) == place(file))
          throw BadValue("report is '" + report + "'; it must be another file than the meshes and their materials");
  mesh_tools::check_text_writable(report);
}

// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON checks its own invariants only, and does not throw
struct Smoothed {
  mesh_tools::FlatFile file;
  mesh_tools::SourceFile source;
  SmoothingReport report;
  ordered_json json;
};

Smoothed smooth_input(const Options& options, const FilePair& pair, const MethodInfo& method,
                      SmoothingParameters parameters, const vcg_core::Progress& progress) {
  mesh_tools::check_writable(pair.output, pair.input);
  Smoothed result;
  result.file = read_flat_input(pair.input, &result.source);
  for (const vcg_core::ParameterInfo& row : method.parameters) {
    if (!row.values.by_selection || options.parameters.given(row) || !has_selection(result.file.mesh)) continue;
    row.set(parameters, 1);
    if (!options.quiet)
      std::cerr << pair.input << ": has a selection: only selected vertices move (--no-selected moves all)\n";
  }
  std::vector<double> weights = weights_of(options.limits, result.file, result.source);
  const HiddenVertices hidden(result.file.mesh);
  if (const std::size_t count = hidden.count; count > 0)
    print_warnings({pair.input + ": " + std::to_string(count) +
                    (count == 1 ? " vertex that no face uses has" : " vertices that no face uses have") +
                    " coordinates that are not finite; the filter passes over " + (count == 1 ? "it" : "them")});
  const CooperativeInterrupt scope;
  result.report = smooth_file(result.file, method.method, parameters, progress, options.limits.limits,
                              std::move(weights), hidden.marks)
                      .report;
  result.json = smoothing_json(method, parameters, options.limits, result.report);
  return result;
}

/// Whether the mesh is to be smoothed in pieces, as it would take more memory than the user allows.
bool is_too_large(const Options& options, const std::string& input, vcg_core::Method method) {
  return !options.memory.empty() && tiles::memory_of_whole(input, method) > memory_size(options.memory);
}

tiles::Finished smooth_in_pieces(const Options& options, const FilePair& pair, const MethodInfo& method,
                                 const SmoothingParameters& parameters, const vcg_core::Progress& progress,
                                 const std::string& report) {
  if (!options.limits.weights.empty()) throw BadValue("weights cannot be used for a mesh that is smoothed in pieces");
  mesh_tools::check_writable(pair.output, pair.input);
  const tiles::Job job{method.method, parameters, options.limits.limits, options.parameters.given_as_no("selected")};
  const auto tell = [&](const std::string& sentence) {
    if (!options.quiet) std::cerr << pair.input << ": is smoothed in pieces; " << sentence << "\n";
  };
  const CooperativeInterrupt scope;
  return tiles::smooth_in_pieces(pair.input, pair.output, memory_size(options.memory), job, progress, tell,
                                 report_file(report));
}

void run_one_in_pieces(const Options& options, const FilePair& pair, const MethodInfo& method,
                       const SmoothingParameters& parameters) {
  tiles::Finished finished;
  {
    ProgressBar bar(options.quiet);
    finished = smooth_in_pieces(options, pair, method, parameters, bar.callback(), options.report);
    result_is_in_place();
  }
  print_warnings(finished.report.warnings());
  if (!options.quiet) print_summary(pair.output, method, finished.report);
}

void run_one(const Options& options, const FilePair& pair, const MethodInfo& method,
             const SmoothingParameters& parameters) {
  if (is_too_large(options, pair.input, method.method)) return run_one_in_pieces(options, pair, method, parameters);
  Smoothed result;
  {
    ProgressBar bar(options.quiet);
    result = smooth_input(options, pair, method, parameters, bar.callback());
  }
  std::optional<mesh_tools::TextFile> text;
  if (!options.report.empty()) text = {options.report, json_text(result.json)};
  write_moved_result(result.file, result.source, pair.output, parameters.smooth_color, text ? &*text : nullptr);
  print_warnings(result.report.warnings());
  if (!options.quiet) print_summary(pair.output, method, result.report);
}

void run(const Options& options) {
  const MethodInfo& method = vcg_core::method_info(options.method);
  const SmoothingParameters parameters = options.parameters.applied_to(method);
  print_warnings(options.parameters.without_effect(method));
  options.limits.limits.validate();
  if (!options.memory.empty()) memory_size(options.memory);
  const std::vector<FilePair> pairs = options.files.pairs();
  check_report_path(options.report, pairs);
  if (!options.files.are_many()) return run_one(options, pairs[0], method, parameters);
  smooth_each(pairs, options.report, options.quiet, [&](const FilePair& pair, const vcg_core::Progress& progress) {
    if (is_too_large(options, pair.input, method.method)) {
      const tiles::Finished finished = smooth_in_pieces(options, pair, method, parameters, progress, {});
      return smoothing_json(method, parameters, options.limits, finished.report);
    }
    Smoothed result = smooth_input(options, pair, method, parameters, progress);
    write_moved_output(result.file, result.source, pair.output, parameters.smooth_color);
    return std::move(result.json);
  });
}

std::string method_help() {
  std::string text = "The filter:";
  for (const MethodInfo& info : vcg_core::methods()) text += "\n" + info.name + ": " + info.title;
  return text + "\npaper moves coarse convex shapes outwards, laplacian and hc shrink them: there use guided. ";
}

}  // namespace

std::function<void()> declare_smooth(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  options->files.declare(app);
  app.add_option("--method", options->method, method_help())->capture_default_str();
  options->parameters.declare(app);
  declare_limits(app, options->limits);
  app.add_option(
      "--memory", options->memory,
      "Use no more memory than about this, such as 4G: a larger binary PLY or STL file is smoothed in pieces,"
      " with about twice its size of disk space beside OUT meanwhile [default: no limit]");
  app.add_option("--report", options->report,
                 "Also write what was done to this file, as JSON; with --out-dir as a list");
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
