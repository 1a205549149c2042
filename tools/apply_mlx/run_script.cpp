// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_script.h"

#include <new>

#include <QAction>
#include <QStringList>

#include <common/globals.h>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>

#include "failure.h"
#include "parameter_values.h"

namespace apply_mlx {
namespace {

bool go_on(int /*percent*/, const char* /*stage*/) { return true; }

struct FoundFilter {
  QAction* action;
  FilterPlugin* plugin;
};

FoundFilter find_filter(const QString& name) {
  const PluginManager& manager = meshlab::pluginManagerInstance();
  QAction* action = meshlab::pluginManagerInstance().filterAction(name);
  if (action == nullptr) {
    throw Failure(QString("unknown filter '%1': none of the %2 loaded plugins has it").arg(name).arg(manager.size()));
  }
  return {action, manager.getFilterPluginFromAction(action)};
}

void check_applicable(const FoundFilter& filter, const MeshDocument& document) {
  if (filter.plugin->requiresGLContext(filter.action))
    throw Failure("it needs OpenGL, which only MeshLab's window has");
  QStringList missing;
  if (document.mm() != nullptr && !filter.plugin->isFilterApplicable(filter.action, *document.mm(), missing)) {
    throw Failure("the mesh lacks what it needs: " + missing.join(", "));
  }
}

/// What a filter has made becomes part of the mesh, as in MeshLab's window: many filters only declare it.
void take_up(const FoundFilter& filter, unsigned int changed, MeshDocument& document) {
  constexpr int attributes =
      MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY | MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY;
  int made =
      changed == MeshModel::MM_UNKNOWN || changed == MeshModel::MM_ALL ? 0 : static_cast<int>(changed) & attributes;
  const int classes = filter.plugin->getClass(filter.action);
  if (classes & FilterPlugin::VertexColoring) made |= MeshModel::MM_VERTCOLOR;
  if (classes & FilterPlugin::FaceColoring) made |= MeshModel::MM_FACECOLOR;
  if (document.mm() != nullptr) document.mm()->updateDataMask(made);
  for (MeshModel& mesh : document.meshIterator()) vcg::tri::Allocator<CMeshO>::CompactEveryVector(mesh.cm);
}

void apply(const FoundFilter& filter, const Step& step, MeshDocument& document) {
  check_applicable(filter, document);
  if (document.mm() != nullptr) document.mm()->updateDataMask(filter.plugin->getRequirements(filter.action));
  RichParameterList values = filter.plugin->initParameterList(filter.action, document);
  set_values(step.parameters, values);
  filter.plugin->setLog(&document.Log);
  unsigned int changed = MeshModel::MM_UNKNOWN;
  filter.plugin->applyFilter(filter.action, values, document, changed, go_on);
  if (changed == MeshModel::MM_UNKNOWN)
    changed = static_cast<unsigned int>(filter.plugin->postCondition(filter.action));
  take_up(filter, changed, document);
}

}  // namespace

void run_script(const std::vector<Step>& steps, MeshDocument& document,
                const std::function<void(const QString& filter)>& started) {
  std::vector<FoundFilter> filters;
  filters.reserve(steps.size());
  for (const Step& step : steps) filters.push_back(find_filter(step.filter));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    started(steps[i].filter);
    const auto fail = [&](const QString& what) {
      throw Failure(QString("filter '%1': %2").arg(steps[i].filter, what));
    };
    try {
      apply(filters[i], steps[i], document);
    } catch (const std::bad_alloc&) {
      fail("not enough memory");
    } catch (const std::exception& error) {
      fail(QString::fromUtf8(error.what()));
    }
  }
}

}  // namespace apply_mlx
