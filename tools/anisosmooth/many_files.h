// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <vcg_core/progress.h>

namespace anisosmooth {

/// A mesh to smooth, and where the result goes.
struct FilePair {
  std::string input, output;
};

/// The files of a command: IN OUT, or IN... with --out-dir DIR.
class FileArguments {
 public:
  /// Declares both forms; what fits neither is a wrong command line.
  void declare(CLI::App& app);

  bool are_many() const { return !folder_.empty(); }

  /// What is to be done, in the order of the command line; in the place of a folder come the meshes in it, by name, not
  /// those in its sub-folders. The folder of --out-dir is made if it is not there.
  /// @throws BadValue  two files would get the same output, a folder holds no mesh, or the one of --out-dir cannot be
  /// made
  std::vector<FilePair> pairs() const;

 private:
  std::vector<std::string> paths_;
  std::string folder_;
};

/// Smooths many files, each for itself: prints a line for each, shows progress over all, and goes on where one fails.
/// @param smooth  gives what the report says of one file; its progress is of that file
/// @param report  where these reports go as a JSON list; none if empty
/// @throws std::runtime_error if one failed; vcg_core::Cancelled if the user interrupts: finished files stay
void smooth_each(const std::vector<FilePair>& pairs, const std::string& report, bool quiet,
                 const std::function<nlohmann::ordered_json(const FilePair&, const vcg_core::Progress&)>& smooth);

}  // namespace anisosmooth
