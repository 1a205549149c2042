// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictures.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

#include <durable_files/replace_file.h>
#include <vcg_core/errors.h>

#include "camera.h"
#include "interrupt.h"
#include "programs.h"
#include "surface_error.h"

namespace anisosmooth {
namespace {

namespace fs = std::filesystem;
using Color = std::array<double, 3>;

constexpr int tile_pixels = 300;
constexpr const char* font = "DejaVu-Sans";

/// A folder beside the results, new and of an unpredictable name, that goes when the work is over.
class WorkFolder {
 public:
  explicit WorkFolder(const fs::path& parent) {
    std::string name = (parent / ".pictures-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::runtime_error(parent.string() + ": no folder can be made in it: " + std::strerror(errno));
    path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// One of the meshes side by side.
struct Tile {
  std::string name;   ///< of files
  std::string label;  ///< for people
  const Positions* positions;
};

std::string short_title(const std::string& method) {
  static const std::pair<const char*, const char*> titles[] = {{"laplacian", "Laplacian"}, {"hc", "improved Laplacian"},
                                                               {"taubin", "Taubin"},       {"jones", "Jones"},
                                                               {"bmd", "Fleishman"},       {"paper", "this filter"}};
  for (const auto& [name, title] : titles)
    if (method == name) return title;
  return method;
}

std::string with_error(const std::string& title, const std::optional<mesh_tools::Measurement>& figures) {
  if (!figures) return title;
  char text[32];
  std::snprintf(text, sizeof text, ": %.2f°", figures->normal_error.mean);
  return title + text;
}

/// The scale of the errors: light where there is none.
Color error_color(double fraction) {
  static constexpr std::array<Color, 5> stops{
      {{240, 242, 245}, {254, 224, 139}, {252, 141, 89}, {215, 48, 39}, {110, 0, 40}}};
  const double position = std::clamp(fraction, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t lower = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const double t = position - static_cast<double>(lower);
  Color color;
  for (int k = 0; k < 3; ++k) color[k] = (1 - t) * stops[lower][k] + t * stops[lower + 1][k];
  return color;
}

/// The least of some round numbers that nineteen of twenty values lie below.
double round_limit(std::vector<double> values) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  const double power = std::pow(10, std::floor(std::log10(std::max(*place, 1e-6))));
  for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (*place <= factor * power) return factor * power;
  return 10 * power;
}

void write_ramp(const fs::path& path) {
  constexpr int width = 700, height = 20, margin = 10;
  const auto color_at = [](int x) {
    const bool outside = x < margin || x >= width - margin;
    return outside ? Color{255, 255, 255} : error_color((x - margin) / (width - 2.0 * margin - 1));
  };
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << width << " " << height << "\n255\n";
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const double channel : color_at(x)) file.put(static_cast<char>(std::lround(channel)));
}

class Studio {
 public:
  Studio(const Comparison& comparison, const View& view, const fs::path& folder)
      : comparison_(comparison), view_(view), work_(folder), noisy_(positions_of(comparison.noisy.mesh)) {
    vcg::tri::Append<mesh_tools::Mesh, mesh_tools::Mesh>::MeshCopy(
        canvas_.mesh, const_cast<mesh_tools::Mesh&>(comparison.noisy.mesh));
    canvas_.precision = mesh_tools::Precision::single_precision;
    tiles_.push_back({"noisy", with_error("noisy", comparison.noisy_figures), &noisy_});
    for (const MethodRun& run : comparison.runs)
      tiles_.push_back({run.method.name, with_error(short_title(run.method.name), run.figures), &run.positions});
  }

  /// Draws all single pictures.
  void shoot() {
    const double e = comparison_.runs.front().report.average_edge_length;
    const Region region = strongest_region(comparison_.noisy.mesh, noisy_, mean_normal_errors(comparison_), 10 * e);
    const std::string whole = f3d_options(camera_around(noisy_, view_.direction, view_.up), tile_pixels);
    vcg::Point3d view = view_.direction;
    const vcg::Point3d close_direction = region.normal + view.Normalize() * 0.4;
    const std::string close =
        f3d_options(camera_at(region.center, region.radius, close_direction, view_.up), tile_pixels);

    set_error_scale();
    std::ostringstream script;
    const std::string options = " --dry-run --quiet --bg-color=1,1,1 --roughness=0.9";
    for (const Tile& tile : tiles_) {
      write_tile(tile);
      const std::string start = "f3d " + tile.name;
      const std::string colored = " --scalars=RGBA --comp=-2";
      script << start << ".ply" << options << whole << " --output=" << tile.name << "_whole.png\n"
             << start << ".ply" << options << close << " --output=" << tile.name << "_close.png\n"
             << start << "_error.ply" << options << whole << colored << " --output=" << tile.name << "_error.png\n";
    }
    std::ofstream(work_.path() / "draw.sh") << "set -e\n" << script.str();
    run({"xvfb-run", "-a", "-s", "-screen 0 640x480x24", "sh", "draw.sh"});
    // f3d's light leaves white at two thirds of the range.
    std::vector<std::string> lighten = {"mogrify", "-level", "0,66%"};
    for (const Tile& tile : tiles_)
      for (const char* kind : {"_whole.png", "_close.png", "_error.png"}) lighten.push_back(tile.name + kind);
    run(lighten);
  }

  void join_figure_9() {
    join_row("_whole.png", "", "whole.png");
    join_row("_close.png", "enlarged", "close.png");
    finish({"convert", "-background", "white", "whole.png", "close.png", "-append"}, "figure9.png");
  }

  void join_errors() {
    join_row("_error.png", "", "tiles.png");
    write_ramp(work_.path() / "ramp.ppm");
    run({"convert", "-background", "white", "-gravity", "center", "-font", font, "-pointsize", "16",
         "label:" + error_name_ + ": 0", "ramp.ppm", "label:" + error_limit_text() + " or more", "+append",
         "-bordercolor", "white", "-border", "8", "scale.png"});
    finish({"convert", "-background", "white", "-gravity", "center", "tiles.png", "scale.png", "-append"},
           "errors.png");
  }

  const fs::path& folder() const { return work_.path(); }

 private:
  /// The pictures of all meshes side by side, each with its name or with `label`.
  void join_row(const std::string& kind, const std::string& label, const std::string& file) const {
    std::vector<std::string> command = {"montage", "-font",     font,   "-pointsize", "16", "-background",
                                        "white",   "-geometry", "+3+3", "-tile",      "x1"};
    for (const Tile& tile : tiles_)
      command.insert(command.end(), {"-label", label.empty() ? tile.label : label, tile.name + kind});
    command.push_back(file);
    run(command);
  }

  /// Writes the picture without the time and the like, so that the same input gives the same file.
  void finish(std::vector<std::string> command, const std::string& file) const {
    command.insert(command.end(), {"-strip", "-define", "png:exclude-chunks=date,time", file});
    run(command);
  }

  std::vector<double> errors(const Tile& tile) const {
    if (comparison_.reference)
      return normal_errors(comparison_.noisy.mesh, *tile.positions, positions_of(comparison_.reference->mesh));
    std::vector<double> displacement(noisy_.size());
    for (std::size_t i = 0; i < displacement.size(); ++i)
      displacement[i] = ((*tile.positions)[i] - noisy_[i]).Norm() / comparison_.runs.front().report.average_edge_length;
    return displacement;
  }

  /// One scale for all: what the middle one of the methods needs, so that the worst do not bleach the others.
  void set_error_scale() {
    std::vector<double> limits;
    for (std::size_t t = 1; t < tiles_.size(); ++t) limits.push_back(round_limit(errors(tiles_[t])));
    std::sort(limits.begin(), limits.end());
    error_limit_ = limits[limits.size() / 2];
    error_name_ = comparison_.reference ? "error of the normals, degrees"
                                        : "displacement from the noisy mesh, average edge lengths";
  }

  std::string error_limit_text() const {
    std::ostringstream text;
    text << error_limit_;
    return text.str();
  }

  void write_tile(const Tile& tile) {
    if (interrupted()) throw vcg_core::Cancelled();
    set_positions(canvas_.mesh, *tile.positions);
    canvas_.attributes = 0;
    mesh_tools::write_mesh(canvas_, work_.path() / (tile.name + ".ply"));
    const std::vector<double> error = errors(tile);
    for (std::size_t i = 0; i < error.size(); ++i) {
      const Color color = error_color(error[i] / error_limit_);
      const auto channel = [&](int k) { return static_cast<unsigned char>(std::lround(color[k])); };
      canvas_.mesh.vert[i].C() = vcg::Color4b(channel(0), channel(1), channel(2), 255);
    }
    canvas_.attributes = mesh_tools::vertex_color_attribute;
    mesh_tools::write_mesh(canvas_, work_.path() / (tile.name + "_error.ply"));
  }

  void run(const std::vector<std::string>& command) const {
    const int status = run_program(command, work_.path(), "log.txt", interrupted);
    if (interrupted()) throw vcg_core::Cancelled();
    if (status == 0) return;
    std::ifstream log(work_.path() / "log.txt");
    std::string line, last;
    while (std::getline(log, line))
      if (!line.empty()) last = line;
    throw std::runtime_error(command.front() + " ended with status " + std::to_string(status) +
                             (last.empty() ? "" : ": " + last));
  }

  const Comparison& comparison_;
  View view_;
  WorkFolder work_;
  Positions noisy_;
  mesh_tools::MeshFile canvas_;
  std::vector<Tile> tiles_;
  double error_limit_ = 1;
  std::string error_name_;
};

/// A sentence about the first program that is missing; empty if all are there.
std::string missing_program() {
  static constexpr std::pair<const char*, const char*> programs[] = {{"f3d", "f3d"},
                                                                     {"xvfb-run", "xvfb"},
                                                                     {"xauth", "xauth"},
                                                                     {"montage", "imagemagick"},
                                                                     {"convert", "imagemagick"},
                                                                     {"mogrify", "imagemagick"}};
  for (const auto& [program, package] : programs)
    if (!has_program(program))
      return std::string("no pictures: the program ") + program + " is missing (Debian's package " + package + ")";
  return {};
}

}  // namespace

Pictures draw_pictures(const Comparison& comparison, const View& view, const fs::path& folder) {
  Pictures pictures;
  pictures.problem = missing_program();
  if (!pictures.problem.empty()) return pictures;
  const CooperativeInterrupt scope;
  try {
    Studio studio(comparison, view, folder);
    studio.shoot();
    studio.join_figure_9();
    studio.join_errors();
    for (const char* name : {"figure9.png", "errors.png"}) {
      durable_files::replace_file(studio.folder() / name, durable_files::final_target(folder / name));
      pictures.files.emplace_back(name);
    }
  } catch (const vcg_core::Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    pictures.problem = std::string("no pictures: ") + error.what();
  }
  return pictures;
}

}  // namespace anisosmooth
