#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <durable_files/replace_file.h>
#include <mesh_tools/mesh_io.h>
#include <vcg_core/smoothing_parameters.h>

#include "command.h"
#include "interrupt.h"
#include "json_figures.h"
#include "mesh_output.h"
#include "progress_bar.h"
#include "smooth_file.h"

namespace anisosmooth {
namespace {

using vcg_core::Boundary;
using vcg_core::GaussianForm;
using vcg_core::MethodInfo;
using vcg_core::SmoothingParameters;
using vcg_core::SmoothingReport;

struct Options {
  std::string input, output, report;
  std::string method = "paper", gaussian = "standard_deviation";
  std::optional<std::string> boundary;
  std::optional<double> sigma_c, sigma_s, sigma_n, rho, strength, feature_angle;
  std::optional<int> iterations;
  std::optional<bool> smooth_color;
  std::optional<bool> selected;  // empty: if the file has a selection
  int threads = 0;
  bool check = false;
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

template <class Value>
Value chosen(const char* name, const std::string& text, const std::pair<const char*, Value> (&allowed)[2]) {
  for (const auto& [word, value] : allowed)
    if (text == word) return value;
  throw BadValue(std::string(name) + " is '" + text + "'; allowed are " + allowed[0].first + " and " +
                 allowed[1].first);
}

/// The method's own defaults, replaced by what the user gave; values without effect are named on stderr.
SmoothingParameters parameters_of(const Options& options, const MethodInfo& method) {
  SmoothingParameters parameters = method.defaults;
  std::vector<std::string> warnings;
  const auto take = [&](const char* name, const auto& given, auto& value) {
    if (!given) return;
    value = *given;
    if (!method.uses(name)) warnings.push_back(std::string(name) + " has no effect with method " + method.name);
  };
  take("sigma_c", options.sigma_c, parameters.sigma_c);
  take("sigma_s", options.sigma_s, parameters.sigma_s);
  take("sigma_n", options.sigma_n, parameters.sigma_n);
  take("rho", options.rho, parameters.rho);
  take("iterations", options.iterations, parameters.iterations);
  take("strength", options.strength, parameters.strength);
  take("feature_angle", options.feature_angle, parameters.feature_angle);
  take("smooth_color", options.smooth_color, parameters.smooth_color);
  if (options.boundary)
    parameters.boundary =
        chosen<Boundary>("boundary", *options.boundary, {{"fixed", Boundary::fixed}, {"free", Boundary::free}});
  parameters.gaussian = chosen<GaussianForm>(
      "gaussian", options.gaussian,
      {{"standard_deviation", GaussianForm::standard_deviation}, {"printed", GaussianForm::printed}});
  parameters.check = options.check;
  parameters.threads = options.threads;
  parameters.validate(method.fewest_iterations);
  print_warnings(warnings);
  return parameters;
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
  SmoothingParameters parameters = parameters_of(options, method);
  mesh_tools::check_writable(options.output);
  check_report_path(options);
  mesh_tools::OriginalFile original;
  mesh_tools::MeshFile file = read_input(options.input, &original);
  parameters.selected_only = options.selected.value_or(has_selection(file.mesh));
  if (parameters.selected_only && !options.selected && !options.quiet)
    std::cerr << "the file has a selection: only selected vertices move (--no-selected moves all)\n";
  SmoothingReport report;
  {
    const CooperativeInterrupt scope;
    ProgressBar bar(options.quiet);
    report = smooth_file(file, method.method, parameters, bar.callback()).report;
  }
  std::optional<mesh_tools::TextFile> text;
  if (!options.report.empty()) {
    nlohmann::ordered_json json = {{"method", method.name}, {"parameters", to_json(method, parameters)}};
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
  app.add_option(
      "--sigma-c", options->sigma_c,
      "Standard deviation of the closeness weight, in average edge lengths; the neighbourhood grows with it; "
      "> 0 [default 2; the paper uses 2 to 6]");
  app.add_option("--sigma-s", options->sigma_s,
                 "Standard deviation of the similarity weight, in average edge lengths: the height of what counts as "
                 "noise; > 0 [default 1; the paper uses 0.5 to 2]");
  app.add_option("--sigma-n", options->sigma_n,
                 "Standard deviation of the normal weight, without unit: smaller keeps more edges; > 0 [default 0.3; "
                 "the paper uses 0.1 to 0.3]");
  app.add_option("--rho", options->rho, "Cut-off distance of the neighbourhood, in sigma_c; > 0 [default 2]");
  app.add_option(
      "--iterations", options->iterations,
      "Number of passes; >= 1 [default 1; the other filters have their own; 0 with method guided: by the noise]");
  app.add_option("--strength", options->strength,
                 "Method guided: strength, as a multiple of what the mesh's own noise asks for; above 0, at most 10 "
                 "[default 1]");
  app.add_option("--feature-angle", options->feature_angle,
                 "Method guided: angle between faces, in degrees, from which an edge is kept; above 0, at most 90 "
                 "[default 30]");
  app.add_flag_callback(
      "--smooth-color", [options] { options->smooth_color = true; },
      "Method guided: smooth the vertices' colour and quality as well, but not over edges");
  app.add_option("--boundary", options->boundary,
                 "Whether border vertices move: fixed or free [default fixed; method guided: free]");
  CLI::Option* selected = app.add_flag_callback(
      "--selected", [options] { options->selected = true; },
      "Move only selected vertices and those of selected faces [default: if the file has a selection]");
  app.add_flag_callback(
         "--no-selected", [options] { options->selected = false; }, "Move all vertices")
      ->excludes(selected);
  app.add_option("--gaussian", options->gaussian,
                 "Exponent of the weights: standard_deviation, or printed as in the paper's formulas")
      ->capture_default_str();
  app.add_flag("--check", options->check, "Also count the faces of the result that cut through others");
  app.add_option("--threads", options->threads, "Number of threads, 0 for one a processor; the result is the same")
      ->capture_default_str();
  app.add_option("--report", options->report, "Also write what was done to this file, as JSON");
  app.add_flag("--quiet", options->quiet, "Print warnings and errors only");
  return [options] { run(*options); };
}

}  // namespace anisosmooth
