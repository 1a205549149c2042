// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <vector>

#include <mesh_tools/mesh_io.h>
#include <vcg_core/errors.h>

#include "command.h"
#include "interrupt.h"

namespace anisosmooth {

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << "\n";
}

namespace {

constexpr char no_memory[] = "not enough memory for this mesh";

constexpr Command commands[] = {
    {"smooth", "Smooth a mesh and keep its edges", declare_smooth},
    {"geodesic", "Geodesic distances from a vertex, as vertex quality and colour", declare_geodesic},
    {"noise", "Add noise to the vertices: Gaussian, correlated, impulsive, of depth cameras, in steps", declare_noise},
    {"measure", "Compare a result with the truth", declare_measure},
    {"compare", "The six methods of the paper's Table 1 side by side: meshes, figures, pictures", declare_compare},
    {"generate", "Make a test shape", declare_generate},
    {"tiles", "Smooth meshes of any size in pieces, on one machine or many", declare_tiles},
};

/// Allocates nothing: there may be no memory left.
int fail(const char* what) {
  std::cerr << "anisosmooth: " << what << "\n";
  return bad_input;
}

int run(int argc, char** argv) {
  CLI::App app("Anisotropic feature-preserving smoothing of triangle meshes.", "anisosmooth");
  app.set_version_flag("--version", ANISO_VERSION);
  app.require_subcommand(1);
  app.footer("Exit status: 0 done, 1 bad input, parameter or file, 2 wrong command line, 130 interrupted.");
  std::function<void()> work;
  for (const Command& command : commands) {
    CLI::App* subcommand = app.add_subcommand(command.name, command.description);
    const std::function<void()> action = command.declare(*subcommand);
    subcommand->callback([&work, action] { work = action; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_command_line;
  }
  try {
    work();
    std::cout.flush();
    if (std::fflush(stdout) != 0 || !std::cout) return fail("standard output cannot be written");
    return done;
  } catch (const vcg_core::Cancelled&) {
    return interrupted_status;
  } catch (const mesh_tools::WriteInterrupted&) {
    return interrupted_status;
  } catch (const std::bad_alloc&) {
    return fail(no_memory);
  } catch (const std::length_error&) {  // more than the address space could hold
    return fail(no_memory);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace
}  // namespace anisosmooth

int main(int argc, char** argv) {
  try {
    anisosmooth::handle_interrupts();
    return anisosmooth::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return anisosmooth::fail(anisosmooth::no_memory);
  } catch (...) {  // run() reports what it knows; here even that failed, as when no memory is left
    std::fputs("anisosmooth: unexpected failure\n", stderr);
    return anisosmooth::bad_input;
  }
}
