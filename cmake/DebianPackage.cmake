# SPDX-License-Identifier: GPL-3.0-or-later
# `cpack` in the build folder makes a Debian package of the plugin. MeshLab takes plugins of exactly its own version, so
# the package depends on the installed MeshLab's, which brings every library that the plugin needs.

if(NOT TARGET filter_anisotropic_smooth OR CMAKE_VERSION VERSION_LESS 3.22)  # which tells the distribution
  return()
endif()
execute_process(COMMAND dpkg-query --showformat=\${Version} --show meshlab
  OUTPUT_VARIABLE meshlab_package_version ERROR_QUIET RESULT_VARIABLE unknown)
cmake_host_system_information(RESULT distribution QUERY DISTRIB_VERSION_CODENAME)
if(unknown OR NOT distribution)
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL plugin)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CONTACT "${PROJECT_NAME}'s maintainers")
set(CPACK_DEBIAN_PLUGIN_PACKAGE_NAME meshlab-filter-anisotropic-smooth)
set(CPACK_DEBIAN_PLUGIN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~${distribution})
set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS "meshlab (= ${meshlab_package_version})")
set(CPACK_DEBIAN_PLUGIN_PACKAGE_SECTION graphics)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Anisotropic feature-preserving smoothing for MeshLab")
set(CPACK_COMPONENT_PLUGIN_DESCRIPTION
  "Filters that remove noise from triangle meshes and keep their sharp edges, in MeshLab's window and scripts.")
set(CPACK_STRIP_FILES ON)
# Packed is what has been built: a package of the plugin asks for no tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
include(CPack)
