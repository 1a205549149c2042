# SPDX-License-Identifier: GPL-3.0-or-later
# Finds what a MeshLab plugin is built against and offers the target MeshLab::Common.
#
# MESHLAB_SOURCE_DIR  root of MeshLab's source tree, for the headers; must be the sources of the library's own version
# MESHLAB_LIBRARY     libmeshlab-common.so of the MeshLab that is to load the plugin
# MESHLAB_SCALAR      float or double: the precision that MeshLab was built with; left empty, the library's own
#
# Sets MeshLab_VERSION (content of ML_VERSION, such as 2020.09), MeshLab_SCALAR and MeshLab_PLUGIN_DIR (where that MeshLab
# looks), and MeshLab_USER_PLUGIN_DIR (where it looks below a user's home; empty before 2021).
# Sources and library of two MeshLabs would make a plugin that does not load, or crashes: such a pair is refused.

include(MeshLabPairing)

set(MESHLAB_SOURCE_DIR "${CMAKE_SOURCE_DIR}/build/_meshlab-source" CACHE PATH "Root of MeshLab's source tree")
set(MESHLAB_SCALAR "" CACHE STRING "Precision of the MeshLab that loads the plugin: float or double; empty: as its library")
set_property(CACHE MESHLAB_SCALAR PROPERTY STRINGS "" float double)

find_library(MESHLAB_LIBRARY meshlab-common
  PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/meshlab /usr/lib/meshlab /usr/local/lib/meshlab
  DOC "libmeshlab-common of the MeshLab that loads the plugin")
find_package(Qt5 QUIET COMPONENTS Core Gui Widgets OpenGL Xml)
find_package(OpenGL QUIET)
find_package(GLEW QUIET)

unset(MeshLab_VERSION)
if(EXISTS ${MESHLAB_SOURCE_DIR}/ML_VERSION)
  file(STRINGS ${MESHLAB_SOURCE_DIR}/ML_VERSION MeshLab_VERSION LIMIT_COUNT 1)
endif()

# Which generation of the plugin interface the sources hold; the compatibility header asks the same question.
unset(MESHLAB_FILTER_HEADER)
foreach(header IN ITEMS common/interfaces.h common/plugins/interfaces/filter_plugin.h)
  if(EXISTS ${MESHLAB_SOURCE_DIR}/src/${header})
    set(MESHLAB_FILTER_HEADER ${MESHLAB_SOURCE_DIR}/src/${header})
  endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MeshLab
  REQUIRED_VARS MESHLAB_LIBRARY MESHLAB_FILTER_HEADER MeshLab_VERSION Qt5_FOUND GLEW_FOUND OPENGL_FOUND
  VERSION_VAR MeshLab_VERSION
  REASON_FAILURE_MESSAGE "run scripts/setup, or give -DMESHLAB_SOURCE_DIR and -DMESHLAB_LIBRARY, or build without the \
plugin by -DANISO_BUILD_PLUGIN=OFF")

if(MeshLab_FOUND)
  aniso_check_meshlab_pairing(MeshLab_SCALAR)
  get_filename_component(MeshLab_LIBRARY_DIR ${MESHLAB_LIBRARY} DIRECTORY)
  set(MeshLab_PLUGIN_DIR ${MeshLab_LIBRARY_DIR}/plugins)
  # The version that a plugin states, and the name of the user's folder, as MeshLab's own build sets them.
  set(_stated_version ${MeshLab_VERSION})
  set(_precision fp)
  if(MeshLab_SCALAR STREQUAL double)
    set(_precision dp)
    if(MESHLAB_FILTER_HEADER MATCHES "filter_plugin.h")
      string(APPEND _stated_version d)
    endif()
  endif()
  set(MeshLab_USER_PLUGIN_DIR "")
  if(MESHLAB_FILTER_HEADER MATCHES "filter_plugin.h")
    set(MeshLab_USER_PLUGIN_DIR VCG/MeshLab_64bit_${_precision}/MeshLabExtraPlugins/${_stated_version})
  endif()
endif()

if(MeshLab_FOUND AND NOT TARGET MeshLab::Common)
  add_library(MeshLab::Common SHARED IMPORTED)
  set_target_properties(MeshLab::Common PROPERTIES IMPORTED_LOCATION ${MESHLAB_LIBRARY})
  target_include_directories(MeshLab::Common SYSTEM INTERFACE ${MESHLAB_SOURCE_DIR}/src)
  target_compile_definitions(MeshLab::Common INTERFACE
    MESHLAB_SCALAR=${MeshLab_SCALAR} MESHLAB_VERSION=${_stated_version})
  target_link_libraries(MeshLab::Common INTERFACE
    Vcglib::Vcglib Qt5::Core Qt5::Gui Qt5::Widgets Qt5::OpenGL Qt5::Xml GLEW::GLEW OpenGL::GL)
  message(STATUS "Plugin for MeshLab ${MeshLab_VERSION} (${MeshLab_SCALAR}), loaded from ${MeshLab_PLUGIN_DIR}")
endif()
