// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <json_figures/json_figures.h>
#include <tiles/tiles.h>
#include <vcg_core/method.h>
#include <vcg_core/smoothing_report.h>

#include "limit_options.h"

namespace anisosmooth {

/// What was done, for people, on standard output.
void print_summary(const std::string& output, const vcg_core::MethodInfo& method,
                   const vcg_core::SmoothingReport& report);

/// The report of one run, as JSON.
nlohmann::ordered_json smoothing_json(const vcg_core::MethodInfo& method,
                                      const vcg_core::SmoothingParameters& parameters, const LimitOptions& limits,
                                      const vcg_core::SmoothingReport& report);

/// For a mesh that was smoothed in pieces: a report at `path`; none if that is empty.
tiles::ReportFile report_file(const std::string& path);

}  // namespace anisosmooth
