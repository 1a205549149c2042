// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <mesh_tools/measure.h>
#include <vcg_core/method.h>
#include <vcg_core/smoothing_report.h>

namespace anisosmooth {

/// JSON with the names of the contract, in its order.
nlohmann::ordered_json to_json(const vcg_core::SmoothingReport& report);
nlohmann::ordered_json to_json(const mesh_tools::Measurement& figures);

/// The value of one parameter: a number, true or false, or the name of a choice.
nlohmann::ordered_json to_json(const vcg_core::ParameterInfo& row, const vcg_core::SmoothingParameters& parameters);

/// The parameters that a method obeys, by name.
nlohmann::ordered_json to_json(const vcg_core::MethodInfo& method, const vcg_core::SmoothingParameters& parameters);

/// The text of a JSON file. A file name's bytes that are not UTF-8, which JSON cannot hold, become U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace anisosmooth
