// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vcg_core {

struct SmoothingParameters;
enum class Boundary;
enum class GaussianForm;
enum class Blend;

/// The values that a parameter may have.
struct Values {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double least = 0;   ///< of numbers; all are finite
  bool open = false;  ///< least itself is not among them
  double most = unlimited;
  const char* meaning_of_least = "";
  std::vector<const char*> choices = {};  ///< names of the values of an enumeration, in its order
  bool by_selection = false;              ///< of a switch: on by default where the mesh has a selection
};

inline Values above(double least, double most = Values::unlimited) { return {least, true, most}; }
inline Values at_least(double least, const char* meaning_of_least = "") {
  return {least, false, Values::unlimited, meaning_of_least};
}
inline Values one_of(std::vector<const char*> choices) {
  Values values;
  values.choices = std::move(choices);
  return values;
}
inline Values on_or_off() { return {}; }
inline Values on_with_selection() {
  Values values;
  values.by_selection = true;
  return values;
}

/// One row of a filter's table of parameters: all that a program needs to offer a parameter, to read, check and report
/// its value, and to describe it. A value of any kind is a double: a switch is 0 or 1, a choice its index in `choices`.
struct ParameterInfo {
  enum class Kind { real, integer, flag, choice };
  using Member =
      std::variant<double SmoothingParameters::*, int SmoothingParameters::*, bool SmoothingParameters::*,
                   Boundary SmoothingParameters::*, GaussianForm SmoothingParameters::*, Blend SmoothingParameters::*>;

  Member member;
  std::string name;   ///< in scripts and reports; on the command line with dashes
  std::string label;  ///< in MeshLab's dialog; empty where MeshLab's filter has no such parameter
  std::string help;   ///< sentences: what it is, and what rises when it rises
  Values values;
  std::string usual = {};      ///< values that suit, or that the paper uses; goes on after the allowed ones
  const char* unit = nullptr;  ///< of real numbers: "" where there is none

  Kind kind() const;
  double value(const SmoothingParameters& parameters) const;
  /// @param value  one that the member can hold; it may be out of the range
  void set(SmoothingParameters& parameters, double value) const;
  /// Sets a choice by its name. @throws InvalidParameter with name, word and what is allowed
  void set_choice(SmoothingParameters& parameters, const std::string& word) const;
  /// The value in words: "0.3", "on", "fixed".
  std::string text(const SmoothingParameters& parameters) const;

  /// "above 0, at most 10", "1 or more", "fixed or free", "on or off".
  std::string allowed() const;
  /// Help, range, usual values and unit, as sentences.
  std::string description() const;
  /// @throws InvalidParameter with name, value and what is allowed if the value is not allowed
  void require_valid(const SmoothingParameters& parameters) const;
};

/// The same row for a filter that MeshLab has without it. Filters that were released keep their parameters there.
inline ParameterInfo without_label(ParameterInfo row) {
  row.label.clear();
  return row;
}

}  // namespace vcg_core
