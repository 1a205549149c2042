// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins.h"

#include <QDir>
#include <QFileInfo>

#include <common/globals.h>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>

#include "failure.h"

namespace apply_mlx {

void load_plugins(const std::vector<std::string>& files) {
  PluginManager& manager = meshlab::pluginManagerInstance();
  const QDir folder(MESHLAB_PLUGIN_DIR);
  for (const QString& file : folder.entryList({"*.so"}, QDir::Files)) {
    try {
      manager.loadPlugin(folder.absoluteFilePath(file));
    } catch (const MLException&) {  // as those that draw, where a library for that is missing
      continue;
    }
  }
  if (manager.size() == 0)
    throw Failure(folder.path() + ": no plugin of MeshLab's own was found; is MeshLab installed?");
  for (const std::string& name : files) {
    const QFileInfo file(QString::fromStdString(name));
    if (!file.exists()) throw Failure(QString::fromStdString(name) + ": there is no such plugin");
    try {
      manager.loadPlugin(file.canonicalFilePath());
    } catch (const MLException& error) {
      throw Failure(QString::fromStdString(name) + ": cannot be loaded: " + error.what());
    }
  }
}

}  // namespace apply_mlx
