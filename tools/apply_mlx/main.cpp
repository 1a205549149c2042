// SPDX-License-Identifier: GPL-3.0-or-later
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QLocale>

#include <common/globals.h>

#include "failure.h"
#include "filter_script.h"
#include "mesh_files.h"
#include "plugins.h"
#include "quiet.h"
#include "run_script.h"

namespace apply_mlx {
namespace {

enum ExitStatus { done = 0, failed = 1, bad_command_line = 2 };

struct Options {
  std::string input, output, script;
  std::vector<std::string> plugins;
};

std::string version() {
  return "apply_mlx " ANISO_VERSION " for MeshLab " + meshlab::meshlabVersion() +
         (meshlab::builtWithDoublePrecision() ? " (double)" : " (float)");
}

int fail(const std::string& what) {
  std::cerr << "apply_mlx: " << what << "\n";
  return failed;
}

/// Filters expect a Qt application with images and fonts, but no screen. It would set the user's locale, and where that
/// has a decimal comma, vcglib's readers and writers of text would cut every number at its point: as MeshLab's window
/// does, numbers stay as in C. File names stay in the user's encoding.
class Application {
 public:
  explicit Application(char** argv) : application_(argc_, argv) {
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
  }

 private:
  int argc_ = 1;
  const bool offscreen_ = ::setenv("QT_QPA_PLATFORM", "offscreen", 1) == 0;
  const QApplication application_;
};

/// @return what the filters logged
std::vector<std::string> run(const Options& options) {
  const QString input = QString::fromStdString(options.input);
  const QString output = QString::fromStdString(options.output);
  const std::vector<Step> steps = read_script(QString::fromStdString(options.script));
  load_plugins(options.plugins);
  check_writable(output);
  MeshDocument document;
  const int attributes = read_mesh(input, document);
  std::vector<std::string> log;
  const auto take_log = [&] {
    for (const auto& [level, line] : document.Log.logStringList()) log.push_back(line.trimmed().toStdString());
    document.Log.clear();
  };
  run_script(steps, document, [&](const QString& filter) {
    take_log();
    log.push_back("filter '" + filter.toStdString() + "'");
  });
  take_log();
  if (document.mm() == nullptr) throw Failure("the script has left no mesh to write");
  write_mesh(*document.mm(), attributes, output);
  return log;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Applies the filters of a MeshLab script to a mesh, as meshlabserver did: without a display.",
               "apply_mlx");
  Options options;
  app.add_option("-i", options.input, "Mesh to read, of any format that MeshLab reads")->required();
  app.add_option("-o", options.output, "Where the result goes, in any format that MeshLab writes; may be the same file")
      ->required();
  app.add_option("-s", options.script, "Filter script (.mlx); parameters that it leaves out keep their defaults")
      ->required();
  app.add_option("--plugin", options.plugins, "A plugin (.so) besides those of the installed MeshLab; may be repeated")
      ->allow_extra_args(false);
  app.set_version_flag("--version", version());
  app.footer(
      "Exit status: 0 done; 1 a file, filter, parameter or value is bad, and nothing is written; 2 wrong command "
      "line.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_command_line;
  }
  std::vector<std::string> log;
  try {
    const Quiet quiet;
    const Application application(argv);
    log = run(options);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory for this mesh");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  for (const std::string& line : log) std::cout << line << "\n";
  std::cout.flush();
  return std::cout ? done : fail("standard output cannot be written");
}

}  // namespace
}  // namespace apply_mlx

int main(int argc, char** argv) {
  try {
    return apply_mlx::parse_and_run(argc, argv);
  } catch (...) {  // parse_and_run() reports what it knows; here even that failed
    std::fputs("apply_mlx: unexpected failure\n", stderr);
    return 1;
  }
}
