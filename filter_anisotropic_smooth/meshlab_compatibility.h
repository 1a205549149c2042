// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place that knows how MeshLab's plugin interface differs between its versions: 2020.09; 2021.05 to 2022.02;
// 2023.12 to 2025.07. Which one applies is told by the header that exists. Above this file, a filter is a
// meshlab_plugin::Filter, whatever the version.

// Qt 5's moc has no __has_include, but it passes over headers that do not exist.
#if defined(Q_MOC_RUN) || __has_include(<common/plugins/interfaces/filter_plugin.h>)
#include <common/plugins/interfaces/filter_plugin.h>
#endif
#ifdef FILTER_PLUGIN_IID
#define ANISO_MESHLAB_SINCE_2021 1
#include <common/globals.h>
#else
#define ANISO_MESHLAB_SINCE_2021 0
#include <common/interfaces.h>
#endif
#include <common/mlexception.h>

#include <QtPlugin>

#include <map>
#include <new>
#include <string>
#include <utility>

namespace meshlab_plugin {

using Report = std::map<std::string, QVariant>;

#if ANISO_MESHLAB_SINCE_2021
using HostInterface = FilterPlugin;
using FilterId = FilterPlugin::ActionIDType;
using ActionPointer = const QAction*;
#define ANISO_INTERFACE FilterPlugin
#define ANISO_INTERFACE_ID FILTER_PLUGIN_IID
#define ANISO_CONST const
#define ANISO_PYTHON_NAME_OVERRIDE override
#else
using HostInterface = MeshFilterInterface;
using FilterId = MeshCommonInterface::FilterIDType;
using ActionPointer = QAction*;
#define ANISO_INTERFACE MeshFilterInterface
#define ANISO_INTERFACE_ID MESH_FILTER_INTERFACE_IID
#define ANISO_CONST
#define ANISO_PYTHON_NAME_OVERRIDE
#endif

/// What a real number of a parameter list is: single precision, but in MeshLabs since 2021 that were built for double.
using ParameterNumber = decltype(std::declval<const RichParameterList&>().getFloat(QString()));

/// MeshLab's own update after coordinates have changed; its name was capitalised in old versions.
template <class Model>
auto update_box_and_normals(Model& model, int) -> decltype(model.updateBoxAndNormals()) {
  model.updateBoxAndNormals();
}
template <class Model>
auto update_box_and_normals(Model& model, long) -> decltype(model.UpdateBoxAndNormals()) {
  model.UpdateBoxAndNormals();
}

/// Turns the version-dependent virtual functions into a few that are the same everywhere.
class HostAdapter : public QObject, public HostInterface {
 public:
  QString pluginName() const override { return QStringLiteral("FilterAnisotropicSmooth"); }

  /// Parameters with their defaults; `mesh` is the current one, or null if there is none.
  virtual RichParameterList parameters_for(const QAction* action, const MeshModel* mesh) const = 0;
  /// Runs the filter; throws std::exception, whose text is for the user.
  virtual Report run(const QAction* action, const RichParameterList& values, MeshModel* mesh,
                     vcg::CallBackPos* callback) = 0;
  /// What run() changes with these values; later MeshLabs update and redraw nothing else.
  virtual int changes_with(const QAction* action, const RichParameterList& values) const = 0;
  virtual void write_log(const std::string& line) = 0;
  virtual QString error_text(const std::exception& error) const = 0;
  /// For what is thrown and is no std::exception.
  static QString unknown_error() { return QStringLiteral("unknown error"); }

#if ANISO_MESHLAB_SINCE_2021
  /// MeshLab refuses a plugin of another version or precision than its own.
  std::pair<std::string, bool> getMLVersion() const override {
    return {meshlab::meshlabVersion(), meshlab::builtWithDoublePrecision()};
  }

  FilterArity filterArity(const QAction*) const override { return SINGLE_MESH; }

  using HostInterface::initParameterList;
  RichParameterList initParameterList(const QAction* action, const MeshDocument& document) override {
    return parameters_for(action, document.mm());
  }

  Report applyFilter(const QAction* action, const RichParameterList& values, MeshDocument& document,
                     unsigned int& changed, vcg::CallBackPos* callback) override {
    try {
      const int parts = changes_with(action, values);  // first: once the mesh has changed, nothing may fail
      Report report = run(action, values, document.mm(), callback);
      changed = static_cast<unsigned int>(parts);
      return report;
    } catch (const std::exception& error) {
      throw MLException(error_text(error));
    } catch (...) {
      throw MLException(unknown_error());
    }
  }

 protected:
  void host_log(const std::string& line) { log(line); }
#else
  FILTER_ARITY filterArity(QAction*) const override { return SINGLE_MESH; }

  using HostInterface::initParameterSet;
  void initParameterSet(QAction* action, MeshDocument& document, RichParameterList& list) override {
    list.join(parameters_for(action, document.mm()));
  }

  /// An exception that leaves this function would end MeshLab 2020.09, and meshlabserver prints the log but not
  /// `errorMessage`.
  bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& values,
                   vcg::CallBackPos* callback) override {
    try {
      run(action, values, document.mm(), callback);
      return true;
    } catch (const std::exception& error) {
      errorMessage = error_text(error);
    } catch (...) {
      errorMessage = unknown_error();
    }
    try {
      write_log("Error: " + errorMessage.toStdString());
    } catch (const std::bad_alloc&) {  // errorMessage says it as well
    }
    return false;
  }

 protected:
  void host_log(const std::string& line) { Log(line); }
#endif
};

}  // namespace meshlab_plugin
