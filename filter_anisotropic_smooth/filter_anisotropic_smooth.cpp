// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_anisotropic_smooth.h"

#include "filters.h"

#include <vcg_core/errors.h>

#include <QAction>

#include <new>

using meshlab_plugin::Filter;
using meshlab_plugin::FilterId;

namespace {

/// MeshLab handles events while a filter reports progress, so a user can start a filter while one is running.
class RunningMark {
 public:
  explicit RunningMark(bool& running) : running_(running) {
    if (running_) {
      throw vcg_core::Error("a filter of this plugin is still running; start the next one when it has finished");
    }
    running_ = true;
  }
  RunningMark(const RunningMark&) = delete;
  RunningMark& operator=(const RunningMark&) = delete;
  ~RunningMark() { running_ = false; }

 private:
  bool& running_;
};

}  // namespace

FilterAnisotropicSmooth::FilterAnisotropicSmooth() : filters_(meshlab_plugin::all_filters()) {
  for (std::size_t id = 0; id < filters_.size(); ++id) {
    typeList.push_back(static_cast<FilterId>(id));
    actionList.push_back(new QAction(filters_[id].name, this));
  }
}

QString FilterAnisotropicSmooth::filterName(FilterId id) const { return filters_.at(id).name; }

QString FilterAnisotropicSmooth::filterInfo(FilterId id) const {
  return filters_.at(id).help + "<br>Version " ANISO_VERSION " of the plugin.";
}

QString FilterAnisotropicSmooth::pythonFilterName(FilterId id) const { return filters_.at(id).python_name; }

FilterAnisotropicSmooth::FilterClass FilterAnisotropicSmooth::getClass(meshlab_plugin::ActionPointer action)
    ANISO_CONST {
  return static_cast<FilterClass>(filter(action).categories);
}

int FilterAnisotropicSmooth::getPreConditions(meshlab_plugin::ActionPointer /*action*/) const {
  return MeshModel::MM_FACENUMBER;
}

int FilterAnisotropicSmooth::postCondition(meshlab_plugin::ActionPointer action) const {
  return filter(action).changes;
}

RichParameterList FilterAnisotropicSmooth::parameters_for(const QAction* action, const MeshModel* mesh) const {
  return filter(action).parameters(mesh);
}

meshlab_plugin::Report FilterAnisotropicSmooth::run(const QAction* action, const RichParameterList& values,
                                                    MeshModel* mesh, vcg::CallBackPos* callback) {
  const RunningMark mark(running_);
  if (mesh == nullptr) throw vcg_core::InvalidMesh("there is no mesh; open one first");
  meshlab_plugin::Session session;
  session.progress = [callback](double fraction, const char* stage) {
    return callback == nullptr || callback(static_cast<int>(fraction * 100), stage);
  };
  session.log = [this](const std::string& line) { write_log(line); };
  return filter(action).apply(*mesh, values, session);
}

int FilterAnisotropicSmooth::changes_with(const QAction* action, const RichParameterList& values) const {
  return filter(action).changes_with(values);
}

void FilterAnisotropicSmooth::write_log(const std::string& line) { host_log(line); }

QString FilterAnisotropicSmooth::error_text(const std::exception& error) const {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return QStringLiteral("not enough memory; nothing was changed");
  }
  if (dynamic_cast<const vcg_core::Cancelled*>(&error) != nullptr) {
    return QStringLiteral("cancelled; nothing was changed");
  }
  return QString::fromUtf8(error.what());
}

/// By the action's text, as MeshLab does: the GUI may have put a shortcut's & into it.
const Filter& FilterAnisotropicSmooth::filter(const QAction* action) const {
  const QString text = action->text().remove('&');
  for (const Filter& candidate : filters_) {
    if (candidate.name == text) return candidate;
  }
  throw vcg_core::Error("this plugin has no filter of the name \"" + text.toStdString() + "\"");
}
