// SPDX-License-Identifier: GPL-3.0-or-later
// describe_methods: all methods and their tables of parameters, as JSON, for scripts/document_parameters and
// scripts/describe_for_meshlab2.

#include <cmath>
#include <exception>
#include <iostream>

#include <nlohmann/json.hpp>

#include <vcg_core/method.h>

namespace {

using nlohmann::ordered_json;
using vcg_core::ParameterInfo;
using vcg_core::SmoothingParameters;

const char* kind_name(ParameterInfo::Kind kind) {
  switch (kind) {
    case ParameterInfo::Kind::real:
      return "real";
    case ParameterInfo::Kind::integer:
      return "integer";
    case ParameterInfo::Kind::flag:
      return "flag";
    case ParameterInfo::Kind::choice:
      return "choice";
  }
  return "";
}

/// In words for documents; then, from "kind" on, for programs.
ordered_json describe(const ParameterInfo& row, const SmoothingParameters& defaults) {
  ordered_json json = {
      {"name", row.name},
      {"default", row.text(defaults) + (row.values.by_selection ? "; on if there is a selection" : "")},
      {"allowed", row.allowed()},
      {"help", row.help},
      {"usual", row.usual},
      {"unit", row.unit == nullptr ? "" : row.unit},
      {"label", row.label},
      {"kind", kind_name(row.kind())},
      {"value", row.value(defaults)},
      {"least", row.values.least},
      {"open", row.values.open},
      {"by_selection", row.values.by_selection},
      {"choices", row.values.choices}};
  if (std::isfinite(row.values.most)) json["most"] = row.values.most;
  return json;
}

ordered_json describe(const vcg_core::MethodInfo& method) {
  ordered_json json = {{"name", method.name}, {"title", method.title}};
  for (const ParameterInfo& row : method.parameters) json["parameters"].push_back(describe(row, method.defaults));
  return json;
}

ordered_json describe_all() {
  ordered_json json;
  for (const vcg_core::MethodInfo& method : vcg_core::methods()) json["methods"].push_back(describe(method));
  for (const ParameterInfo& row : vcg_core::run_parameters<SmoothingParameters>())
    json["run"].push_back(describe(row, {}));
  return json;
}

}  // namespace

int main() {
  try {
    std::cout << describe_all().dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << "describe_methods: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
