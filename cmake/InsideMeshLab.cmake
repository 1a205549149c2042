# SPDX-License-Identifier: GPL-3.0-or-later
# This folder lies in MeshLab's own tree (src/meshlabplugins, from 2021 on) or in one laid out as meshlab-extra-plugins:
# MeshLab's build brings library, vcglib, version, precision and folders; only the plugin is added to it.

set(CMAKE_AUTOMOC OFF)
set(CMAKE_AUTOUIC OFF)
set(CMAKE_AUTORCC OFF)
find_package(Threads REQUIRED)
add_library(Vcglib::Vcglib ALIAS vcglib)
add_library(MeshLab::Common ALIAS meshlab-common)

add_subdirectory(vcg_core)
add_subdirectory(filter_anisotropic_smooth)
