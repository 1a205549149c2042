// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue.h"

#include <algorithm>
#include <string>

#include <nanobind/stl/string.h>
#include <vcg_core/errors.h>

namespace anisosmooth_python {

namespace nb = nanobind;
using vcg_core::MethodInfo;
using vcg_core::ParameterInfo;

namespace {

const char* kind_name(ParameterInfo::Kind kind) {
  switch (kind) {
    case ParameterInfo::Kind::real:
      return "float";
    case ParameterInfo::Kind::integer:
      return "int";
    case ParameterInfo::Kind::flag:
      return "bool";
    case ParameterInfo::Kind::choice:
      return "str";
  }
  return "";
}

nb::object to_python(const ParameterInfo& row, double value) {
  switch (row.kind()) {
    case ParameterInfo::Kind::real:
      return nb::float_(value);
    case ParameterInfo::Kind::integer:
      return nb::int_(static_cast<int>(value));
    case ParameterInfo::Kind::flag:
      return nb::bool_(value != 0);
    case ParameterInfo::Kind::choice:
      return nb::str(row.values.choices[static_cast<std::size_t>(value)]);
  }
  return nb::none();
}

double number_of(const ParameterInfo& row, nb::handle value) {
  if (row.kind() == ParameterInfo::Kind::flag) {
    const int truth = PyObject_IsTrue(value.ptr());
    if (truth < 0) throw nb::python_error();
    return truth;
  }
  // What is no whole number is none for an int, as everywhere in Python. Numpy's numbers are fine.
  const bool whole = row.kind() == ParameterInfo::Kind::integer;
  const nb::object number = nb::steal(whole ? PyNumber_Index(value.ptr()) : PyNumber_Float(value.ptr()));
  if (!number.is_valid()) throw nb::python_error();
  const double result = PyFloat_AsDouble(number.ptr());
  if (result == -1 && PyErr_Occurred()) throw nb::python_error();
  if (whole && result != static_cast<double>(static_cast<int>(result)))
    throw vcg_core::InvalidParameter(row.name + " is too large a number");
  return result;
}

void set(const ParameterInfo& row, vcg_core::SmoothingParameters& parameters, nb::handle value) {
  if (row.kind() != ParameterInfo::Kind::choice) return row.set(parameters, number_of(row, value));
  if (!nb::isinstance<nb::str>(value)) throw nb::type_error((row.name + " must be of type str").c_str());
  row.set_choice(parameters, nb::cast<std::string>(value));
}

nb::dict to_python(const ParameterInfo& row, const vcg_core::SmoothingParameters& defaults) {
  nb::dict entry;
  entry["name"] = row.name;
  entry["kind"] = kind_name(row.kind());
  entry["default"] = to_python(row, row.value(defaults));
  nb::list choices;
  for (const char* choice : row.values.choices) choices.append(choice);
  entry["choices"] = choices;
  entry["by_selection"] = row.values.by_selection;
  entry["help"] = row.description();
  return entry;
}

}  // namespace

nb::dict catalogue() {
  nb::dict methods;
  for (const MethodInfo& info : vcg_core::methods()) {
    nb::list parameters;
    for (const ParameterInfo& row : info.parameters) parameters.append(to_python(row, info.defaults));
    nb::dict entry;
    entry["title"] = info.title;
    entry["parameters"] = parameters;
    methods[info.name.c_str()] = entry;
  }
  return methods;
}

vcg_core::SmoothingParameters parameters_of(const MethodInfo& method, const nb::dict& given) {
  vcg_core::SmoothingParameters parameters = method.defaults;
  for (const auto [key, value] : given) {
    const auto name = nb::cast<std::string>(key);
    const auto row = std::find_if(method.parameters.begin(), method.parameters.end(),
                                  [&](const ParameterInfo& candidate) { return candidate.name == name; });
    if (row == method.parameters.end())
      throw nb::type_error((name + " is no parameter of method " + method.name).c_str());
    set(*row, parameters, value);
  }
  return parameters;
}

}  // namespace anisosmooth_python
