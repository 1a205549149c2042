// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/parameter_info.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

#include <vcg_core/errors.h>
#include <vcg_core/smoothing_parameters.h>

namespace vcg_core {

namespace {

std::string in_words(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

/// With all digits where the number is a whole one.
std::string in_words(ParameterInfo::Kind kind, double number) {
  return kind == ParameterInfo::Kind::real ? in_words(number) : std::to_string(static_cast<int>(number));
}

/// The words as a list: "a, b or c" with the conjunction "or".
std::string listed(const std::vector<std::string>& words, const std::string& conjunction) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 < words.size() ? ", " : " " + conjunction + " ") + words[k];
  return text;
}

bool is_allowed(const ParameterInfo& row, double value) {
  const Values& values = row.values;
  if (row.kind() == ParameterInfo::Kind::flag) return true;
  if (!values.choices.empty()) return value >= 0 && value < static_cast<double>(values.choices.size());
  return std::isfinite(value) && (values.open ? value > values.least : value >= values.least) && value <= values.most;
}

/// What require_valid() asks for, as the end of its sentence.
std::string demand(const ParameterInfo& row) {
  const Values& values = row.values;
  if (!values.choices.empty()) {
    std::vector<std::string> words;
    for (const char* choice : values.choices) words.push_back(std::to_string(words.size()) + " (" + choice + ")");
    return listed(words, "or");
  }
  if (!values.open) {
    const std::string meaning = values.meaning_of_least;
    return in_words(values.least) + (meaning.empty() ? "" : " (" + meaning + ")") + " or more";
  }
  const std::string least = "greater than " + in_words(values.least);
  if (values.most == Values::unlimited) return "a finite number " + least;
  const std::string unit = row.unit == nullptr ? "" : row.unit;
  return least + " and at most " + in_words(values.most) + (unit.empty() ? "" : " (" + unit + ")");
}

}  // namespace

ParameterInfo::Kind ParameterInfo::kind() const {
  return std::visit(
      [](auto pointer) {
        using Held = std::remove_reference_t<decltype(std::declval<SmoothingParameters&>().*pointer)>;
        if (std::is_enum_v<Held>) return Kind::choice;
        if (std::is_same_v<Held, bool>) return Kind::flag;
        return std::is_same_v<Held, int> ? Kind::integer : Kind::real;
      },
      member);
}

double ParameterInfo::value(const SmoothingParameters& parameters) const {
  return std::visit([&](auto pointer) { return static_cast<double>(parameters.*pointer); }, member);
}

void ParameterInfo::set(SmoothingParameters& parameters, double value) const {
  std::visit(
      [&](auto pointer) {
        using Held = std::remove_reference_t<decltype(parameters.*pointer)>;
        if constexpr (std::is_enum_v<Held>)
          parameters.*pointer = static_cast<Held>(static_cast<int>(value));
        else
          parameters.*pointer = static_cast<Held>(value);
      },
      member);
}

void ParameterInfo::set_choice(SmoothingParameters& parameters, const std::string& word) const {
  const auto& choices = values.choices;
  const auto found = std::find(choices.begin(), choices.end(), word);
  if (found == choices.end())
    throw InvalidParameter(name + " is '" + word + "'; allowed are " + listed({choices.begin(), choices.end()}, "and"));
  set(parameters, static_cast<double>(found - choices.begin()));
}

std::string ParameterInfo::text(const SmoothingParameters& parameters) const {
  const double number = value(parameters);
  if (kind() == Kind::flag) return number != 0 ? "on" : "off";
  if (kind() == Kind::choice) return values.choices.at(static_cast<std::size_t>(number));
  return in_words(kind(), number);
}

std::string ParameterInfo::allowed() const {
  if (kind() == Kind::flag) return "on or off";
  if (kind() == Kind::choice) return listed({values.choices.begin(), values.choices.end()}, "or");
  if (!values.open) return in_words(values.least) + " or more";
  return "above " + in_words(values.least) +
         (values.most == Values::unlimited ? "" : ", at most " + in_words(values.most));
}

std::string ParameterInfo::description() const {
  if (kind() == Kind::flag || kind() == Kind::choice) return help;
  std::string sentence = allowed() + (usual.empty() ? "" : "; " + usual) + ".";
  sentence[0] = sentence[0] == 'a' ? 'A' : sentence[0];
  std::string text = help + " " + sentence;
  if (unit == nullptr) return text;
  return text + (*unit == '\0' ? std::string(" No unit.") : std::string(" Unit: ") + unit + ".");
}

void ParameterInfo::require_valid(const SmoothingParameters& parameters) const {
  const double number = value(parameters);
  if (!is_allowed(*this, number))
    throw InvalidParameter(name + " is " + in_words(kind(), number) + "; it must be " + demand(*this));
}

}  // namespace vcg_core
