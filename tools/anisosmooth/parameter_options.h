// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <vcg_core/method.h>

namespace anisosmooth {

/// The parameters of all methods as options of a command, made from their tables. Methods share an option where their
/// parameters have the same name.
class ParameterOptions {
 public:
  /// @param app  keeps pointers to this object
  void declare(CLI::App& app);

  /// Whether the user gave a value.
  bool given(const vcg_core::ParameterInfo& row) const;

  /// Whether the user switched it off: --no-NAME.
  bool given_as_no(const std::string& name) const;

  /// The method's own defaults, replaced by what the user gave.
  /// @throws BadValue for a word that names no choice, vcg_core::InvalidParameter for a value that is not allowed
  vcg_core::SmoothingParameters applied_to(const vcg_core::MethodInfo& method) const;

  /// A sentence for each value that the method does not know.
  std::vector<std::string> without_effect(const vcg_core::MethodInfo& method) const;

 private:
  void declare(CLI::App& app, const vcg_core::ParameterInfo& row, const std::string& text);

  std::map<std::string, double> number_;     ///< what was given, by the parameter's name; a switch is 0 or 1
  std::map<std::string, std::string> word_;  ///< the same of choices
};

}  // namespace anisosmooth
