// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>
#include <vcg_core/method.h>

namespace anisosmooth_python {

/// The core's tables of methods and parameters as Python's dictionaries: {method: {title, parameters: [{name, kind,
/// default, choices, help, allowed}]}}. Signatures and documentation are made from them.
nanobind::dict catalogue();

/// The method's defaults, replaced by the values given by name. Ranges are not checked.
/// @throws vcg_core::InvalidParameter for a choice that there is not; nanobind::type_error for a value of another kind,
///         or a name that the method does not know
vcg_core::SmoothingParameters parameters_of(const vcg_core::MethodInfo& method, const nanobind::dict& given);

}  // namespace anisosmooth_python
