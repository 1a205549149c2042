// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <json_figures/json_figures.h>
#include <mesh_tools/mesh_io.h>
#include <tiles/tiles.h>

#include "command.h"
#include "interrupt.h"
#include "limit_options.h"
#include "parameter_options.h"
#include "progress_bar.h"
#include "smooth_summary.h"

namespace anisosmooth {
namespace {

struct PlanOptions {
  std::string input, plan, method = "paper";
  long long tile_vertices = 1'000'000;
  ParameterOptions parameters;
  vcg_core::SmoothingLimits limits;
  bool quiet = false;
};

void run_plan(const PlanOptions& options) {
  constexpr long long fewest = 100, most = 1'000'000'000;
  if (options.tile_vertices < fewest || options.tile_vertices > most)
    throw BadValue("tile_vertices is " + std::to_string(options.tile_vertices) + "; allowed are " +
                   std::to_string(fewest) + " to " + std::to_string(most));
  const vcg_core::MethodInfo& method = vcg_core::method_info(options.method);
  const tiles::Job job{method.method, options.parameters.applied_to(method), options.limits,
                       options.parameters.given_as_no("selected")};
  print_warnings(options.parameters.without_effect(method));
  options.limits.validate();
  {
    const CooperativeInterrupt scope;
    ProgressBar bar(options.quiet);
    tiles::make_plan(options.input, options.plan, static_cast<std::size_t>(options.tile_vertices), job, bar.callback(),
                     [&](const std::string& sentence) {
                       if (!options.quiet) std::cerr << options.plan << ": " << sentence << "\n";
                     });
    result_is_in_place();
  }
  if (options.quiet) return;
  const tiles::PlanSummary plan = tiles::plan_summary(options.plan);
  std::cout << plan.vertices << " vertices, " << plan.faces << " faces in " << plan.tiles << " pieces, the largest of "
            << plan.largest_tile << " vertices; about " << plan.memory_bytes / 1'000'000
            << " MB of memory a piece\naverage edge length " << plan.average_edge_length << ", each piece sees "
            << plan.halo << " around it\nwritten to " << options.plan << "\n";
}

std::function<void()> declare_plan(CLI::App& app) {
  const auto options = std::make_shared<PlanOptions>();
  app.add_option("IN", options->input, "Mesh: binary PLY or STL, of any size")->required();
  app.add_option("PLAN", options->plan, "Folder for the plan and the pieces; must not be there, or be empty")
      ->required();
  app.add_option("--tile-vertices", options->tile_vertices, "About how many vertices a piece has")
      ->capture_default_str();
  app.add_option("--method", options->method, "The filter: paper or guided")->capture_default_str();
  options->parameters.declare(app);
  declare_limits(app, options->limits);
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run_plan(*options); };
}

struct RunOptions {
  std::string plan;
  std::optional<long long> tile;
  bool all = false, quiet = false;
  int threads = 0;
};

void run_one_tile(const RunOptions& options, std::size_t tile, std::size_t done, std::size_t count) {
  tiles::TileOutcome outcome;
  {
    const CooperativeInterrupt scope;
    ProgressBar bar(options.quiet);
    const vcg_core::Progress of_tile = bar.callback();
    outcome = tiles::run_tile(options.plan, tile, options.threads, [&](double fraction, const char* stage) {
      return of_tile((static_cast<double>(done) + fraction) / static_cast<double>(count), stage);
    });
  }
  if (!outcome.warning.empty()) print_warnings({outcome.warning});
  if (!options.quiet)
    std::cout << "piece " << tile << (outcome.was_done ? ": was done already" : ": done") << std::endl;
}

void run_tiles(const RunOptions& options) {
  if (options.threads < 0)
    throw BadValue("threads is " + std::to_string(options.threads) + "; it must be 0 (one for each processor) or more");
  const std::size_t count = tiles::plan_summary(options.plan).tiles;
  if (!options.all) {
    if (*options.tile < 0 || static_cast<std::size_t>(*options.tile) >= count)
      throw BadValue("tile is " + std::to_string(*options.tile) + "; allowed are 0 to " + std::to_string(count - 1));
    return run_one_tile(options, static_cast<std::size_t>(*options.tile), 0, 1);
  }
  for (std::size_t tile = 0; tile < count; ++tile) run_one_tile(options, tile, tile, count);
}

std::function<void()> declare_run(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  app.add_option("PLAN", options->plan, "Folder that 'tiles plan' made")->required();
  CLI::Option_group* const which = app.add_option_group("which pieces");
  which->add_option("--tile", options->tile, "Smooth this piece; the first is 0");
  which->add_flag("--all", options->all, "Smooth all pieces that are not done yet, one after the other");
  which->require_option(1);
  app.add_option("--threads", options->threads,
                 "Number of threads, 0 for one a processor; the result does not depend on"
                 " it")
      ->capture_default_str();
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run_tiles(*options); };
}

struct FinishOptions {
  std::string plan, output, report;
  bool quiet = false;
};

void run_finish(const FinishOptions& options) {
  mesh_tools::check_writable(options.output);
  if (!options.report.empty()) mesh_tools::check_text_writable(options.report);
  tiles::Finished finished;
  {
    const CooperativeInterrupt scope;
    ProgressBar bar(options.quiet);
    finished = tiles::finish(options.plan, options.output, bar.callback(), report_file(options.report));
    result_is_in_place();
  }
  print_warnings(finished.report.warnings());
  if (!options.quiet) print_summary(options.output, vcg_core::method_info(finished.job.method), finished.report);
}

std::function<void()> declare_finish(CLI::App& app) {
  const auto options = std::make_shared<FinishOptions>();
  app.add_option("PLAN", options->plan, "Folder whose pieces are all done")->required();
  app.add_option("OUT", options->output, "Where the mesh goes, in the format that was read")->required();
  app.add_option("--report", options->report, "Also write what was done to this file, as JSON");
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run_finish(*options); };
}

}  // namespace

std::function<void()> declare_tiles(CLI::App& app) {
  app.require_subcommand(1);
  const auto work = std::make_shared<std::function<void()>>();
  const auto add = [&](const char* name, const char* description, std::function<void()> (*declare)(CLI::App&)) {
    CLI::App* const subcommand = app.add_subcommand(name, description);
    subcommand->callback([work, action = declare(*subcommand)] { *work = action; });
  };
  add("plan", "Cut a mesh of any size into pieces", declare_plan);
  add("run", "Smooth pieces", declare_run);
  add("finish", "Put the smoothed pieces together", declare_finish);
  return [work] { (*work)(); };
}

}  // namespace anisosmooth
