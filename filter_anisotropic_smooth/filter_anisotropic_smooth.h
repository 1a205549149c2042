// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter.h"
#include "meshlab_compatibility.h"

#include <vector>

/// What MeshLab loads: hands out the filters of filters.cpp and runs them.
class FilterAnisotropicSmooth : public meshlab_plugin::HostAdapter {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID ANISO_INTERFACE_ID)
  Q_INTERFACES(ANISO_INTERFACE)

 public:
  FilterAnisotropicSmooth();

  QString filterName(meshlab_plugin::FilterId id) const override;
  QString filterInfo(meshlab_plugin::FilterId id) const override;
  QString pythonFilterName(meshlab_plugin::FilterId id) const ANISO_PYTHON_NAME_OVERRIDE;
  FilterClass getClass(meshlab_plugin::ActionPointer action) ANISO_CONST override;
  int getPreConditions(meshlab_plugin::ActionPointer action) const override;
  int postCondition(meshlab_plugin::ActionPointer action) const override;

  RichParameterList parameters_for(const QAction* action, const MeshModel* mesh) const override;
  meshlab_plugin::Report run(const QAction* action, const RichParameterList& values, MeshModel* mesh,
                             vcg::CallBackPos* callback) override;
  int changes_with(const QAction* action, const RichParameterList& values) const override;
  void write_log(const std::string& line) override;
  QString error_text(const std::exception& error) const override;

 private:
  const meshlab_plugin::Filter& filter(const QAction* action) const;

  std::vector<meshlab_plugin::Filter> filters_;
  bool running_ = false;
};
