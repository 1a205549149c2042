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
class Filter {
 public:
  Filter() = default;
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;
  virtual ~Filter() = default;

  virtual QString name() const = 0;
  virtual QString python_name() const = 0;
  /// HTML: what the filter does, when to use it, where it comes from.
  virtual QString help() const = 0;
  /// Menus: HostInterface::FilterClass values, or-ed.
  virtual int categories() const = 0;
  /// What the filter can change: MeshModel::MM_* values, or-ed. The preview restores nothing else.
  virtual int changes() const = 0;
  /// What it changes with these values: less than that, where a parameter decides.
  virtual int changes_with(const RichParameterList& /*values*/) const { return changes(); }

  /// Parameters with their defaults; `mesh` may be null.
  virtual RichParameterList parameters(const MeshModel* mesh) const = 0;
  /// Changes `mesh`, or throws std::exception with a sentence for the user and the mesh untouched. Nothing is thrown
  /// once the mesh has changed: what is left to say is then left out.
  virtual Report apply(MeshModel& mesh, const RichParameterList& values, const Session& session) const = 0;
};

}  // namespace meshlab_plugin
