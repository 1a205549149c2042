#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <durable_files/replace_file.h>
#include <mesh_tools/mesh_io.h>
#include <vcg_core/method.h>

#include "command.h"
#include "interrupt.h"
#include "json_figures.h"
#include "limit_options.h"
#include "mesh_output.h"
#include "parameter_options.h"
#include "progress_bar.h"
#include "smooth_file.h"

namespace anisosmooth {
namespace {

using vcg_core::MethodInfo;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;

struct Options {
  std::string input, output, report;
  std::string method = "paper";
  ParameterOptions parameters;
  LimitOptions limits;
  bool quiet = false;
};

std::string method_names() {
  std::string names;
  for (const MethodInfo& info : vcg_core::methods()) names += (names.empty() ? "" : ", ") + info.name;
  return names;
}

const MethodInfo& chosen_method(const Options& options) {
  const auto method = vcg_core::method_from_name(options.method);
  if (!method) throw BadValue("method is '" + options.method + "'; allowed are " + method_names());
  return vcg_core::method_info(*method);
}

bool has_selection(const mesh_tools::Mesh& mesh) {
  for (const auto& vertex : mesh.vert)
    if (vertex.IsS()) return true;
  for (const auto& face : mesh.face)
    if (face.IsS()) return true;
  return false;
}

void print_summary(const Options& options, const MethodInfo& method, const SmoothingReport& report) {
  std::cout << method.title << "\n";
  std::cout << "average edge length " << report.average_edge_length;
  if (report.sigma_c_length > 0) std::cout << ", sigma_c " << report.sigma_c_length;
  if (report.sigma_s_length > 0) std::cout << ", sigma_s " << report.sigma_s_length;
  if (report.rho_length > 0) std::cout << ", rho " << report.rho_length;
  if (report.estimated_noise) std::cout << ", estimated noise " << *report.estimated_noise;
  std::cout << "\nmoved " << report.moved_vertices << " of " << report.vertices << " vertices";
  if (report.fixed_vertices > 0) std::cout << ", " << report.fixed_vertices << " held";
  if (report.skipped_vertices.total() > 0) std::cout << ", " << report.skipped_vertices.total() << " skipped";
  std::cout << "; displacement rms " << report.rms_displacement << ", max " << report.max_displacement
            << "\nvolume before " << report.volume_before << ", after " << report.volume_after;
  if (report.flipped_faces > 0) std::cout << "; faces turned over " << report.flipped_faces;
  if (report.bounded_vertices > 0) std::cout << "; vertices held back " << report.bounded_vertices;
  if (report.self_intersections) std::cout << "; faces that cut through others " << *report.self_intersections;
  std::cout << "\nwritten to " << options.output << "\n";
}

void check_report_path(const Options& options) {
  if (options.report.empty()) return;
  namespace fs = std::filesystem;
  const auto place = [](const fs::path& path) {
    return fs::weakly_canonical(fs::absolute(durable_files::final_target(path)));
  };
  for (const std::string& mesh : {options.input, options.output})
    for (const fs::path& file : mesh_tools::files_of(mesh))
      if (place(options.report) == place(file))
        throw BadValue("report is '" + options.report +
                       "'; it must be another file than the meshes and their materials");
  mesh_tools::check_text_writable(options.report);
}

void run(const Options& options) {
  const MethodInfo& method = chosen_method(options);
  SmoothingParameters parameters = options.parameters.applied_to(method);
  print_warnings(options.parameters.without_effect(method));
  options.limits.limits.validate();
  mesh_tools::check_writable(options.output);
  check_report_path(options);
  mesh_tools::OriginalFile original;
  mesh_tools::MeshFile file = read_input(options.input, &original);
  for (const vcg_core::ParameterInfo& row : method.parameters) {
    if (!row.values.by_selection || options.parameters.given(row) || !has_selection(file.mesh)) continue;
    row.set(parameters, 1);
    if (!options.quiet)
      std::cerr << "the file has a selection: only selected vertices move (--no-selected moves all)\n";
  }
  std::vector<double> weights = weights_of(options.limits, file, original);
  SmoothingReport report;
  {
    const CooperativeInterrupt scope;
    ProgressBar bar(options.quiet);
    report =
        smooth_file(file, method.method, parameters, bar.callback(), options.limits.limits, std::move(weights)).report;
  }
  std::optional<mesh_tools::TextFile> text;
  if (!options.report.empty()) {
    nlohmann::ordered_json json = {{"method", method.name}, {"parameters", to_json(method, parameters)}};
    add_limits(options.limits, json["parameters"]);
    json.update(to_json(report));
    text = {options.report, json.dump(2) + "\n"};
  }
  write_moved_result(file, std::move(original), options.output, parameters.smooth_color, text ? &*text : nullptr);
  print_warnings(report.warnings());
  if (!options.quiet) print_summary(options, method, report);
}

std::string method_help() {
  std::string text = "The filter:";
  for (const MethodInfo& info : vcg_core::methods()) text += "\n" + info.name + ": " + info.title;
  return text + "\npaper moves coarse convex shapes outwards, laplacian and hc shrink them: there use guided. ";
}

}  // namespace

std::function<void()> declare_smooth(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("IN", options->input, "Mesh to smooth: PLY, OBJ, OFF or STL")->required();
  app.add_option("OUT", options->output, "Where the result goes; may be the same file")->required();
  app.add_option("--method", options->method, method_help())->capture_default_str();
  options->parameters.declare(app);
  declare_limits(app, options->limits);
  app.add_option("--report", options->report, "Also write what was done to this file, as JSON");
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
