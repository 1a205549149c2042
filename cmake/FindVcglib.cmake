# SPDX-License-Identifier: GPL-3.0-or-later
# Finds vcglib, the header-only library of triangle meshes, and offers the target Vcglib::Vcglib.
#
# VCGLIB_DIR          folder that holds vcg/complex/complex.h; found by itself
#                     below MESHLAB_SOURCE_DIR (2020.09: vcglib/, from 2021: src/vcglib/)
# MESHLAB_SOURCE_DIR  root of a MeshLab source tree; scripts/setup unpacks Debian's to build/_meshlab-source

set(MESHLAB_SOURCE_DIR "${CMAKE_SOURCE_DIR}/build/_meshlab-source" CACHE PATH "Root of MeshLab's source tree")

find_path(VCGLIB_DIR vcg/complex/complex.h
  HINTS ${MESHLAB_SOURCE_DIR}/vcglib ${MESHLAB_SOURCE_DIR}/src/vcglib
  PATHS /usr/include/vcglib /usr/local/include/vcglib
  DOC "Folder that holds vcg/complex/complex.h")
find_package(Eigen3 QUIET NO_MODULE)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Vcglib
  REQUIRED_VARS VCGLIB_DIR Eigen3_FOUND
  REASON_FAILURE_MESSAGE "run scripts/setup, or give -DVCGLIB_DIR=<folder with vcg/> and install Eigen 3")

if(Vcglib_FOUND AND NOT TARGET Vcglib::Vcglib)
  add_library(Vcglib::Vcglib INTERFACE IMPORTED)
  target_include_directories(Vcglib::Vcglib SYSTEM INTERFACE ${VCGLIB_DIR})
  target_link_libraries(Vcglib::Vcglib INTERFACE Eigen3::Eigen)
endif()
