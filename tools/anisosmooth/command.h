// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace anisosmooth {

/// Exit statuses: part of what scripts rely on.
enum ExitStatus { done = 0, bad_input = 1, bad_command_line = 2, interrupted_status = 130 };

/// A value that the command line's grammar allows and the program does not; what() names it and what is allowed.
class BadValue : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A subcommand: declares its options and returns what is to be done once they are parsed.
struct Command {
  const char* name;
  const char* description;
  std::function<void()> (*declare)(CLI::App& app);
};

std::function<void()> declare_smooth(CLI::App& app);
std::function<void()> declare_geodesic(CLI::App& app);
std::function<void()> declare_noise(CLI::App& app);
std::function<void()> declare_measure(CLI::App& app);
std::function<void()> declare_compare(CLI::App& app);
std::function<void()> declare_generate(CLI::App& app);
std::function<void()> declare_tiles(CLI::App& app);

/// One line each on stderr.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace anisosmooth
