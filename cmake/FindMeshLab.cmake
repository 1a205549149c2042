# Finds what a MeshLab plugin is built against and offers the target MeshLab::Common.
#
# MESHLAB_SOURCE_DIR  root of MeshLab's source tree, for the headers; must be the sources of the library's own version
# MESHLAB_LIBRARY     libmeshlab-common.so of the MeshLab that is to load the plugin
# MESHLAB_SCALAR      float or double: the precision that MeshLab was built with (all of Debian's: float)
#
# Sets MeshLab_VERSION (content of ML_VERSION, such as 2020.09) and MeshLab_PLUGIN_DIR (where that MeshLab looks).

set(MESHLAB_SOURCE_DIR "${CMAKE_SOURCE_DIR}/build/_meshlab-source" CACHE PATH "Root of MeshLab's source tree")
set(MESHLAB_SCALAR float CACHE STRING "Precision of the MeshLab that loads the plugin: float or double")
set_property(CACHE MESHLAB_SCALAR PROPERTY STRINGS float double)

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

# Each generation of the library exports a class that the other does not have: a cheap guard against sources of one
# version with the library of another, which would compile and then fail to load, or crash.
if(MESHLAB_LIBRARY AND MESHLAB_FILTER_HEADER AND NOT MESHLAB_PAIRING_CHECKED STREQUAL "${MESHLAB_LIBRARY} ${MESHLAB_FILTER_HEADER}")
  file(STRINGS ${MESHLAB_LIBRARY} _new_interface REGEX "12FilterPlugin" LIMIT_COUNT 1)
  if(MESHLAB_FILTER_HEADER MATCHES "filter_plugin.h")
    set(_sources_new TRUE)
  else()
    set(_sources_new FALSE)
  endif()
  if((_sources_new AND NOT _new_interface) OR (_new_interface AND NOT _sources_new))
    message(FATAL_ERROR "The sources in ${MESHLAB_SOURCE_DIR} are MeshLab ${MeshLab_VERSION}'s, but ${MESHLAB_LIBRARY} "
      "belongs to another MeshLab: a plugin of this pair would not load. Remove the sources and run "
      "scripts/fetch_meshlab_source, or give a matching -DMESHLAB_SOURCE_DIR and -DMESHLAB_LIBRARY.")
  endif()
  set(MESHLAB_PAIRING_CHECKED "${MESHLAB_LIBRARY} ${MESHLAB_FILTER_HEADER}" CACHE INTERNAL "")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MeshLab
  REQUIRED_VARS MESHLAB_LIBRARY MESHLAB_FILTER_HEADER MeshLab_VERSION Qt5_FOUND GLEW_FOUND OPENGL_FOUND
  VERSION_VAR MeshLab_VERSION
  REASON_FAILURE_MESSAGE "run scripts/setup, or give -DMESHLAB_SOURCE_DIR and -DMESHLAB_LIBRARY, or build without the \
plugin by -DANISO_BUILD_PLUGIN=OFF")

if(MeshLab_FOUND AND NOT TARGET MeshLab::Common)
  get_filename_component(MeshLab_LIBRARY_DIR ${MESHLAB_LIBRARY} DIRECTORY)
  set(MeshLab_PLUGIN_DIR ${MeshLab_LIBRARY_DIR}/plugins)
  add_library(MeshLab::Common SHARED IMPORTED)
  set_target_properties(MeshLab::Common PROPERTIES IMPORTED_LOCATION ${MESHLAB_LIBRARY})
  target_include_directories(MeshLab::Common SYSTEM INTERFACE ${MESHLAB_SOURCE_DIR}/src)
  target_compile_definitions(MeshLab::Common INTERFACE
    MESHLAB_SCALAR=${MESHLAB_SCALAR} MESHLAB_VERSION=${MeshLab_VERSION})
  target_link_libraries(MeshLab::Common INTERFACE
    Vcglib::Vcglib Qt5::Core Qt5::Gui Qt5::Widgets Qt5::OpenGL Qt5::Xml GLEW::GLEW OpenGL::GL)
  message(STATUS "Plugin for MeshLab ${MeshLab_VERSION} (${MESHLAB_SCALAR}), loaded from ${MeshLab_PLUGIN_DIR}")
endif()
