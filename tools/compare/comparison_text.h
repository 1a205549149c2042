// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "comparison.h"

namespace anisosmooth {

/// Everything that was measured: parameters, time, report, and with a reference the figures of "measure".
nlohmann::ordered_json to_json(const Comparison& comparison);

/// The same as tables for people.
std::string to_markdown(const Comparison& comparison, const std::string& noisy_name, const std::string& reference_name,
                        const std::vector<std::string>& pictures);

}  // namespace anisosmooth
