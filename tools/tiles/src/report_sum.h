// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <vcg_core/smoothing_report.h>

namespace tiles {

/// All figures of a report, so that it can be read back.
nlohmann::ordered_json report_to_json(const vcg_core::SmoothingReport& report);
vcg_core::SmoothingReport report_from_json(const nlohmann::ordered_json& json);

/// Makes of the report of some pieces that of these and one more. A report of none has vertices = 0.
void add_report(const vcg_core::SmoothingReport& piece, vcg_core::SmoothingReport& sum);

}  // namespace tiles
