// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshfilterplugin.h"

#include <memory>
#include <vector>

struct MeshFilterPluginManager {
  void registerPlugin(std::unique_ptr<MeshFilterPlugin> plugin) { plugins.push_back(std::move(plugin)); }
  std::vector<std::unique_ptr<MeshFilterPlugin>> plugins;
};
