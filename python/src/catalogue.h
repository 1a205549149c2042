#pragma once

#include <nanobind/nanobind.h>
#include <vcg_core/method.h>

namespace anisosmooth_python {

/// The core's tables of methods and parameters as Python's dictionaries: {method: {title, parameters: [{name, kind,
/// default, choices, help, allowed}]}}. Signatures and documentation are made from them.
nanobind::dict catalogue();

/// The method of that name. @throws vcg_core::InvalidParameter
const vcg_core::MethodInfo& method_named(const std::string& name);

/// The method's defaults, replaced by the values given by name; checked.
/// @throws vcg_core::InvalidParameter; nanobind::type_error for a value of another kind, or a name that the method
///         does not know
vcg_core::SmoothingParameters parameters_of(const vcg_core::MethodInfo& method, const nanobind::dict& given);

}  // namespace anisosmooth_python
