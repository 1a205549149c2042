// SPDX-License-Identifier: GPL-3.0-or-later
#include "many_files.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <new>
#include <stdexcept>
#include <system_error>

#include <json_figures/json_figures.h>
#include <mesh_tools/mesh_io.h>
#include <vcg_core/errors.h>

#include "command.h"
#include "interrupt.h"
#include "mesh_output.h"
#include "progress_bar.h"

namespace anisosmooth {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The meshes in a folder, by name.
std::vector<std::string> meshes_in(const fs::path& folder) {
  std::vector<std::string> meshes;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (std::error_code ignored; mesh_tools::has_known_extension(entry->path()) && entry->is_regular_file(ignored))
      meshes.push_back(entry->path().string());
  if (error) throw BadValue(folder.string() + ": cannot be read: " + error.message());
  if (meshes.empty()) throw BadValue(folder.string() + ": holds no meshes; " + mesh_tools::known_extensions());
  std::sort(meshes.begin(), meshes.end());
  return meshes;
}

/// A bar for one file that shows how far all are, by the sizes of the files.
class ProgressOfMany {
 public:
  explicit ProgressOfMany(const std::vector<FilePair>& pairs) : done_before_(1, 0.0) {
    for (const FilePair& pair : pairs) {
      std::error_code error;
      const auto size = fs::file_size(pair.input, error);
      done_before_.push_back(done_before_.back() + (error ? 1.0 : 1.0 + static_cast<double>(size)));
    }
  }

  /// @param bar  referred to, as is this
  vcg_core::Progress of_file(std::size_t index, ProgressBar& bar) const {
    return [this, index, show = bar.callback()](double fraction, const char* stage) {
      const double done = done_before_[index] + fraction * (done_before_[index + 1] - done_before_[index]);
      const std::string which = std::to_string(index + 1) + " of " + std::to_string(done_before_.size() - 1);
      return show(done / done_before_.back(), (which + ": " + stage).c_str());
    };
  }

 private:
  std::vector<double> done_before_;  // of each file, and of all
};

/// The report of one file, or why it failed.
ordered_json smooth_one(const FilePair& pair, const vcg_core::Progress& progress,
                        const std::function<ordered_json(const FilePair&, const vcg_core::Progress&)>& smooth) {
  ordered_json json = {{"input", pair.input}, {"output", pair.output}};
  std::string failure;
  try {
    json.update(smooth(pair, progress));
  } catch (const vcg_core::Cancelled&) {
    throw;
  } catch (const mesh_tools::WriteInterrupted&) {
    throw;
  } catch (const std::bad_alloc&) {
    failure = pair.input + ": not enough memory for this mesh";
  } catch (const std::exception& error) {
    failure = error.what();
    if (failure.find(pair.input) == failure.npos && failure.find(pair.output) == failure.npos)
      failure = pair.input + ": " + failure;
  }
  if (failure.empty()) return json;
  return {{"input", pair.input}, {"error", failure}};
}

void print_line(const ordered_json& json, bool quiet) {
  const auto input = json["input"].get<std::string>();
  if (json.contains("error")) {
    std::cerr << "anisosmooth: " << json["error"].get<std::string>() << "\n";
    return;
  }
  for (const auto& warning : json["warnings"]) print_warnings({input + ": " + warning.get<std::string>()});
  if (!quiet)
    std::cout << input << ": moved " << json["moved_vertices"] << " of " << json["vertices"]
              << " vertices; displacement rms " << json["rms_displacement"] << ", max " << json["max_displacement"]
              << "; written to " << json["output"].get<std::string>() << std::endl;
}

}  // namespace

void FileArguments::declare(CLI::App& app) {
  app.add_option("IN", paths_,
                 "IN OUT: mesh to smooth (PLY, OBJ, OFF, STL, GLB or glTF), and where the result goes; may be the same "
                 "file. With "
                 "--out-dir: any number of meshes, and folders that hold some")
      ->required();
  app.add_option("--out-dir", folder_,
                 "Smooth each IN for itself, and write the results into this folder by the same names");
  app.parse_complete_callback([this] {
    if (are_many()) return;
    if (paths_.size() < 2) throw CLI::RequiredError("OUT, or --out-dir,");
    if (paths_.size() > 2) throw CLI::ExtrasError({paths_.begin() + 2, paths_.end()});
  });
}

std::vector<FilePair> FileArguments::pairs() const {
  if (!are_many()) return {{paths_.front(), paths_.back()}};
  std::vector<FilePair> pairs;
  std::map<std::string, std::string> input_of;
  const auto add = [&](const std::string& input) {
    const std::string name = fs::path(input).filename().string();
    const auto [other, is_new] = input_of.try_emplace(name, input);
    if (!is_new)
      throw BadValue(input + ": has the same name as " + other->second + ", so both would become " +
                     (fs::path(folder_) / name).string() + "; smooth them into two folders");
    pairs.push_back({input, (fs::path(folder_) / name).string()});
  };
  for (const std::string& path : paths_) {
    std::error_code error;
    if (!fs::is_directory(path, error))
      add(path);
    else
      for (const std::string& mesh : meshes_in(path)) add(mesh);
  }
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_, error)) throw BadValue(folder_ + ": cannot be made a folder for the results");
  return pairs;
}

void smooth_each(const std::vector<FilePair>& pairs, const std::string& report, bool quiet,
                 const std::function<ordered_json(const FilePair&, const vcg_core::Progress&)>& smooth) {
  const ProgressOfMany progress(pairs);
  ordered_json list = ordered_json::array();
  std::size_t failed = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    {
      ProgressBar bar(quiet);
      list.push_back(smooth_one(pairs[i], progress.of_file(i, bar), smooth));
    }
    failed += list.back().contains("error");
    print_line(list.back(), quiet);
  }
  if (!report.empty()) write_output(mesh_tools::TextFile{report, json_text(list)});
  if (failed > 0)
    throw std::runtime_error(std::to_string(failed) + " of " + std::to_string(pairs.size()) +
                             " files could not be smoothed");
}

}  // namespace anisosmooth
