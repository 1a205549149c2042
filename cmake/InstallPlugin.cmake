# SPDX-License-Identifier: GPL-3.0-or-later
# Where the plugin is installed: component `plugin` for everybody; `user_plugin`, which has to be asked for, for the user
# who configures.

# Below the prefix as MeshLab's own plugins lie below /usr, so that --prefix /usr puts it where that MeshLab looks.
file(RELATIVE_PATH plugin_dir /usr ${MeshLab_PLUGIN_DIR})
if(plugin_dir MATCHES "^\\.\\./")
  set(plugin_dir ${MeshLab_PLUGIN_DIR})
endif()
set(ANISO_PLUGIN_INSTALL_DIR ${plugin_dir} CACHE STRING "Where the plugin is installed, below the prefix or absolute")
install(TARGETS filter_anisotropic_smooth LIBRARY DESTINATION ${ANISO_PLUGIN_INSTALL_DIR} COMPONENT plugin)

if(DEFINED ENV{XDG_DATA_HOME})
  set(data_home $ENV{XDG_DATA_HOME})
else()
  set(data_home $ENV{HOME}/.local/share)
endif()
if(MeshLab_USER_PLUGIN_DIR)
  install(TARGETS filter_anisotropic_smooth LIBRARY DESTINATION ${data_home}/${MeshLab_USER_PLUGIN_DIR}
    COMPONENT user_plugin EXCLUDE_FROM_ALL)
else()
  install(CODE "message(FATAL_ERROR \"MeshLab ${MeshLab_VERSION} reads no plugins of a user's own, only those beside its \
own: install --component plugin.\")" COMPONENT user_plugin EXCLUDE_FROM_ALL)
endif()
