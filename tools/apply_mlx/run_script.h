// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QString>

#include <common/ml_document/mesh_document.h>

#include "filter_script.h"

namespace apply_mlx {

/// Applies the filters of a script in their order, as MeshLab's GUI does.
/// @param started called with each filter's name before it runs
/// @throws Failure if a filter is unknown (before any has run), cannot be applied, has no such parameter, or fails
void run_script(const std::vector<Step>& steps, MeshDocument& document,
                const std::function<void(const QString& filter)>& started);

}  // namespace apply_mlx
