// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialog_parameters.h"

#include <array>
#include <charconv>
#include <cmath>

namespace meshlab_plugin {

namespace {

using vcg_core::MethodInfo;
using vcg_core::ParameterInfo;
using vcg_core::SmoothingParameters;

bool has_selection(const MeshModel* mesh) {
  if (mesh == nullptr) return false;
  for (const auto& vertex : mesh->cm.vert) {
    if (!vertex.IsD() && vertex.IsS()) return true;
  }
  for (const auto& face : mesh->cm.face) {
    if (!face.IsD() && face.IsS()) return true;
  }
  return false;
}

void add(const ParameterInfo& row, double value, RichParameterList& list) {
  const QString name = QString::fromStdString(row.name);
  const QString label = QString::fromStdString(row.label);
  const QString tooltip = QString::fromStdString(row.description());
  switch (row.kind()) {
    case ParameterInfo::Kind::real:
      list.addParam(RichFloat(name, static_cast<ParameterNumber>(value), label, tooltip));
      break;
    case ParameterInfo::Kind::integer:
      list.addParam(RichInt(name, static_cast<int>(value), label, tooltip));
      break;
    case ParameterInfo::Kind::flag:
      list.addParam(RichBool(name, value != 0, label, tooltip));
      break;
    case ParameterInfo::Kind::choice:
      QStringList choices;
      for (const char* choice : row.values.choices) choices << choice;
      list.addParam(RichEnum(name, static_cast<int>(value), choices, label, tooltip));
  }
}

/// The number that a person meant who typed what was then stored as `value`: the shortest decimal that gives it. So 0.3
/// is 0.3 and not 0.300000012, and dialog, script and command line compute the same: always up to six digits. What a
/// MeshLab that stores single precision has rounded away beyond that is lost before the plugin sees the value.
template <class Number>
double as_typed(Number value) {
  if (!std::isfinite(value)) return value;
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  double typed = value;
  std::from_chars(text.data(), written.ptr, typed);
  return typed;
}

double read(const ParameterInfo& row, const RichParameterList& values) {
  const QString name = QString::fromStdString(row.name);
  switch (row.kind()) {
    case ParameterInfo::Kind::integer:
      return values.getInt(name);
    case ParameterInfo::Kind::flag:
      return values.getBool(name) ? 1 : 0;
    case ParameterInfo::Kind::choice:
      return values.getEnum(name);
    default:
      return as_typed(values.getFloat(name));
  }
}

}  // namespace

RichParameterList to_list(const MethodInfo& method, const MeshModel* mesh) {
  RichParameterList list;
  for (const ParameterInfo& row : method.parameters) {
    if (row.label.empty()) continue;
    add(row, row.values.by_selection ? has_selection(mesh) : row.value(method.defaults), list);
  }
  return list;
}

SmoothingParameters read_values(const MethodInfo& method, const RichParameterList& values) {
  SmoothingParameters parameters = method.defaults;
  for (const ParameterInfo& row : method.parameters)
    if (!row.label.empty()) row.set(parameters, read(row, values));
  return parameters;
}

}  // namespace meshlab_plugin
