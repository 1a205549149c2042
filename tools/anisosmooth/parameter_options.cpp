// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_options.h"

#include <algorithm>
#include <sstream>

#include "command.h"

namespace anisosmooth {
namespace {

using vcg_core::MethodInfo;
using vcg_core::ParameterInfo;
using vcg_core::SmoothingParameters;

/// What some methods say of a parameter, with one voice.
struct Description {
  std::string text;
  std::vector<const MethodInfo*> methods;
};

std::string names(const std::vector<const MethodInfo*>& methods) {
  std::string text;
  for (const MethodInfo* method : methods) text += (text.empty() ? "" : ", ") + method->name;
  return text;
}

template <class Text>
std::vector<Description> descriptions(const std::string& name, const Text& text_of) {
  std::vector<Description> all;
  for (const MethodInfo& method : vcg_core::methods())
    for (const ParameterInfo& row : method.parameters) {
      if (row.name != name) continue;
      const std::string text = text_of(method, row);
      const auto same = std::find_if(all.begin(), all.end(), [&](const Description& d) { return d.text == text; });
      if (same == all.end())
        all.push_back({text, {&method}});
      else
        same->methods.push_back(&method);
    }
  return all;
}

/// "[default 2]", or "[default 1; laplacian, hc: 20]".
std::string default_text(const std::string& name) {
  const auto defaults = descriptions(name, [](const MethodInfo& method, const ParameterInfo& row) {
    return row.values.by_selection ? "on if the file has a selection" : row.text(method.defaults);
  });
  std::string text = "[default " + defaults.front().text;
  for (std::size_t k = 1; k < defaults.size(); ++k) text += "; " + names(defaults[k].methods) + ": " + defaults[k].text;
  return text + "]";
}

/// What the table says; where the tables differ, what each says.
std::string help_of(const std::string& name) {
  const auto helps =
      descriptions(name, [](const MethodInfo& /*method*/, const ParameterInfo& row) { return row.description(); });
  std::string text;
  for (const Description& help : helps) {
    if (help.methods.size() < vcg_core::methods().size())
      text += (help.methods.size() == 1 ? "Method " : "Methods ") + names(help.methods) + ". ";
    text += help.text + " ";
  }
  return text + default_text(name);
}

/// Broken into lines, which CLI11 does not do.
std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 88;
  std::string lines;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool breaks = column + word.size() > width;
    lines += column == 0 ? "" : breaks ? "\n" : " ";
    column = breaks ? 0 : column;
    lines += word;
    column += word.size() + 1;
  }
  return lines;
}

std::string option_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

}  // namespace

void ParameterOptions::declare(CLI::App& app, const ParameterInfo& row, const std::string& text) {
  const std::string help = wrapped(text);
  const std::string& name = row.name;
  const std::string option = option_name(name);
  switch (row.kind()) {
    case ParameterInfo::Kind::real:
      app.add_option_function<double>(
          option, [this, name](double value) { number_[name] = value; }, help);
      break;
    case ParameterInfo::Kind::integer:
      app.add_option_function<int>(
          option, [this, name](int value) { number_[name] = value; }, help);
      break;
    case ParameterInfo::Kind::choice:
      app.add_option_function<std::string>(
          option, [this, name](const std::string& word) { word_[name] = word; }, help);
      break;
    case ParameterInfo::Kind::flag:
      CLI::Option* const on = app.add_flag_callback(
          option, [this, name] { number_[name] = 1; }, help);
      if (row.values.by_selection)
        app.add_flag_callback(
               "--no" + option.substr(1), [this, name] { number_[name] = 0; }, "The opposite")
            ->excludes(on);
  }
}

void ParameterOptions::declare(CLI::App& app) {
  for (const MethodInfo& method : vcg_core::methods())
    for (const ParameterInfo& row : method.parameters)
      if (app.get_option_no_throw(option_name(row.name)) == nullptr) declare(app, row, help_of(row.name));
  const MethodInfo any{{}, {}, {}, vcg_core::run_parameters<SmoothingParameters>()};
  for (const ParameterInfo& row : any.parameters)
    declare(app, row, row.description() + " [default " + row.text(any.defaults) + "]");
}

bool ParameterOptions::given(const ParameterInfo& row) const {
  return number_.count(row.name) > 0 || word_.count(row.name) > 0;
}

bool ParameterOptions::given_as_no(const std::string& name) const {
  const auto found = number_.find(name);
  return found != number_.end() && found->second == 0;
}

SmoothingParameters ParameterOptions::applied_to(const MethodInfo& method) const {
  SmoothingParameters parameters = method.defaults;
  const auto take = [&](const ParameterInfo& row) {
    if (const auto number = number_.find(row.name); number != number_.end()) row.set(parameters, number->second);
    if (const auto word = word_.find(row.name); word != word_.end()) row.set_choice(parameters, word->second);
  };
  for (const ParameterInfo& row : method.parameters) take(row);
  for (const ParameterInfo& row : vcg_core::run_parameters<SmoothingParameters>()) take(row);
  parameters.validate(method.method);
  return parameters;
}

std::vector<std::string> ParameterOptions::without_effect(const MethodInfo& method) const {
  std::vector<std::string> sentences;
  for (const MethodInfo& other : vcg_core::methods())
    for (const ParameterInfo& row : other.parameters) {
      if (!given(row) || method.uses(row.member)) continue;
      const std::string sentence = row.name + " has no effect with method " + method.name;
      if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end()) sentences.push_back(sentence);
    }
  return sentences;
}

}  // namespace anisosmooth
