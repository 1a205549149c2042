// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDomElement>
#include <QString>

namespace apply_mlx {

/// One <filter> of a script, with its <Param> elements as they stand there.
struct Step {
  QString filter;
  std::vector<QDomElement> parameters;
};

/// Reads an .mlx file, as MeshLab's GUI and meshlabserver write and read it. MeshLab's own reader passes over what it
/// does not understand; this one does not.
/// @throws Failure if it cannot be read, is no filter script, or has no filter
std::vector<Step> read_script(const QString& path);

}  // namespace apply_mlx
