// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_compatibility.h"

#include <vcg_core/progress.h>

#include <functional>

namespace meshlab_plugin {

/// What a filter may ask of MeshLab while it runs.
struct Session {
  vcg_core::Progress progress;
  std::function<void(const std::string& line)> log;
};

/// One entry of MeshLab's filter menu. Name, Python name and parameters are held on to by users' scripts: once
/// released they never change.
struct Filter {
  QString name;
  QString python_name;
  QString help;    ///< HTML: what the filter does, when to use it, where it comes from
  int categories;  ///< menus: HostInterface::FilterClass values, or-ed
  int changes;     ///< what it can change: MeshModel::MM_* values, or-ed; the preview restores nothing else
  /// What it changes with these values: less than that, where a parameter decides.
  std::function<int(const RichParameterList& values)> changes_with;
  /// Parameters with their defaults; `mesh` may be null.
  std::function<RichParameterList(const MeshModel* mesh)> parameters;
  /// Changes `mesh`, or throws std::exception with a sentence for the user and the mesh untouched. Nothing is thrown
  /// once the mesh has changed: what is left to say is then left out.
  std::function<Report(MeshModel& mesh, const RichParameterList& values, const Session& session)> apply;
};

}  // namespace meshlab_plugin
