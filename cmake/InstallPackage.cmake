# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the core as a CMake package: find_package(anisotropic_smooth) gives anisotropic_smooth::vcg_core.
# Its headers are templates over vcglib, so the package looks for vcglib and Eigen too; -DVCGLIB_DIR tells where.

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/anisotropic_smooth)

install(TARGETS vcg_core EXPORT anisotropic_smooth-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT core)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/vcg_core/include/vcg_core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT core)
install(EXPORT anisotropic_smooth-targets NAMESPACE anisotropic_smooth:: DESTINATION ${package_dir} COMPONENT core)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/anisotropic_smooth-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/anisotropic_smooth-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/anisotropic_smooth-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/anisotropic_smooth-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/anisotropic_smooth-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindVcglib.cmake
  DESTINATION ${package_dir} COMPONENT core)
