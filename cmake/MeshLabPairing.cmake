# SPDX-License-Identifier: GPL-3.0-or-later
# Refuses pairs of MeshLab's sources and library that do not belong together. FindMeshLab calls it.

# What the file of a libmeshlab-common tells of itself: its version is a string of its own (2022.02, or 2022.02d for double
# precision), its precision stands in the type of an argument of a function that all versions export. Empty if not told.
function(_aniso_ask_meshlab_library library version scalar)
  # PyMeshLab's library has it in the midst of code, where the byte that follows may look like a letter.
  file(STRINGS ${library} stated REGEX "^20[0-9][0-9]\\.[0-9][0-9]d?[A-Z]?$" LIMIT_COUNT 1)
  string(REGEX MATCH "^20[0-9][0-9]\\.[0-9][0-9]" stated "${stated}")
  set(${version} "${stated}" PARENT_SCOPE)
  file(STRINGS ${library} symbol REGEX "setMeshTransformationMatrixEiRKN3vcg8Matrix44I[fd]EE" LIMIT_COUNT 1)
  set(${scalar} "" PARENT_SCOPE)
  if(symbol MATCHES "Matrix44IfEE")
    set(${scalar} float PARENT_SCOPE)
  elseif(symbol MATCHES "Matrix44IdEE")
    set(${scalar} double PARENT_SCOPE)
  endif()
endfunction()

# Stops unless MESHLAB_SOURCE_DIR, VCGLIB_DIR, MESHLAB_LIBRARY and MESHLAB_SCALAR fit; sets `scalar` to float or double.
function(aniso_check_meshlab_pairing scalar)
  _aniso_ask_meshlab_library(${MESHLAB_LIBRARY} library_version library_scalar)

  if(NOT library_version)
    message(WARNING "${MESHLAB_LIBRARY} does not tell its version: make sure that it is MeshLab ${MeshLab_VERSION}, "
      "or the plugin will not load.")
  elseif(NOT library_version STREQUAL MeshLab_VERSION)
    message(FATAL_ERROR "The sources in ${MESHLAB_SOURCE_DIR} are MeshLab ${MeshLab_VERSION}'s, but ${MESHLAB_LIBRARY} "
      "is MeshLab ${library_version}'s: a plugin of this pair would not load. Remove the sources and run "
      "scripts/fetch_meshlab_source, or give a matching -DMESHLAB_SOURCE_DIR and -DMESHLAB_LIBRARY.")
  endif()

  if(MESHLAB_SCALAR AND NOT MESHLAB_SCALAR MATCHES "^(float|double)$")
    message(FATAL_ERROR "MESHLAB_SCALAR is ${MESHLAB_SCALAR}; it must be float or double, or empty for the precision of "
      "MeshLab's library.")
  elseif(MESHLAB_SCALAR AND library_scalar AND NOT MESHLAB_SCALAR STREQUAL library_scalar)
    message(FATAL_ERROR "MESHLAB_SCALAR is ${MESHLAB_SCALAR}, but ${MESHLAB_LIBRARY} was built with ${library_scalar}: "
      "that MeshLab would refuse the plugin. Give -DMESHLAB_SCALAR=${library_scalar}, or another -DMESHLAB_LIBRARY.")
  elseif(NOT MESHLAB_SCALAR AND NOT library_scalar)
    message(FATAL_ERROR "${MESHLAB_LIBRARY} does not tell its precision. Give -DMESHLAB_SCALAR=float or "
      "-DMESHLAB_SCALAR=double.")
  endif()

  # A vcglib that stayed in the cache from other sources has other layouts of the same classes.
  get_filename_component(taken ${VCGLIB_DIR} REALPATH)
  foreach(candidate IN ITEMS ${MESHLAB_SOURCE_DIR}/vcglib ${MESHLAB_SOURCE_DIR}/src/vcglib)
    get_filename_component(own ${candidate} REALPATH)
    if(EXISTS ${own}/vcg/complex/complex.h AND NOT taken STREQUAL own)
      message(FATAL_ERROR "vcglib is taken from ${VCGLIB_DIR}, but the MeshLab that loads the plugin was built with "
        "the one in ${own}, and they may differ. Give -DVCGLIB_DIR=${own}.")
    endif()
  endforeach()

  if(MESHLAB_SCALAR)
    set(${scalar} ${MESHLAB_SCALAR} PARENT_SCOPE)
  else()
    set(${scalar} ${library_scalar} PARENT_SCOPE)
  endif()
endfunction()
