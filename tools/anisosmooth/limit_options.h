// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <mesh_tools/mesh_io.h>
#include <vcg_core/smoothing_limits.h>

namespace anisosmooth {

/// What holds the vertices back, as the user gave it: --weld-distance, --max-displacement, --weights.
struct LimitOptions {
  vcg_core::SmoothingLimits limits;
  std::string weights;  ///< name of a vertex property; empty: none
};

void declare_limits(CLI::App& app, LimitOptions& options);
/// Without --weights.
void declare_limits(CLI::App& app, vcg_core::SmoothingLimits& limits);

/// One weight for each vertex of the file, or none. Throws mesh_tools::FileError.
std::vector<double> weights_of(const LimitOptions& options, const mesh_tools::FlatFile& file,
                               const mesh_tools::SourceFile& source);

/// Adds the values that the user gave.
void add_limits(const LimitOptions& options, nlohmann::ordered_json& json);

}  // namespace anisosmooth
