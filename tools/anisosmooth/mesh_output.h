// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include <mesh_tools/mesh_io.h>

#include "command.h"
#include "interrupt.h"

namespace anisosmooth {

/// Writes the mesh, complete or not at all, also when the user interrupts meanwhile; prints warnings.
/// @param with  appears together with the mesh, or neither of them
inline void write_output(const mesh_tools::MeshFile& file, const std::string& path,
                         const mesh_tools::TextFile* with = nullptr) {
  const CooperativeInterrupt scope;
  print_warnings(mesh_tools::write_mesh(file, path, interrupted, with));
}

/// The same for the one result of a command: once it is there, signals are ignored.
inline void write_result(const mesh_tools::MeshFile& file, const std::string& path,
                         const mesh_tools::TextFile* with = nullptr) {
  const CooperativeInterrupt scope;
  write_output(file, path, with);
  result_is_in_place();
}

/// The same as write_output for a mesh that was read and whose vertices have moved; see mesh_tools::write_moved().
/// @param file, source  a MeshFile and an OriginalFile, or a FlatFile and a SourceFile
template <class File, class Source>
void write_moved_output(File& file, Source source, const std::string& path, bool recolored = false,
                        const mesh_tools::TextFile* with = nullptr) {
  const CooperativeInterrupt scope;
  print_warnings(mesh_tools::write_moved(file, std::move(source), path, recolored, interrupted, with));
}

/// The same as write_result for such a mesh.
template <class File, class Source>
void write_moved_result(File& file, Source source, const std::string& path, bool recolored = false,
                        const mesh_tools::TextFile* with = nullptr) {
  const CooperativeInterrupt scope;
  write_moved_output(file, std::move(source), path, recolored, with);
  result_is_in_place();
}

/// The same as write_output for a text alone.
inline void write_output(const mesh_tools::TextFile& file) {
  const CooperativeInterrupt scope;
  mesh_tools::write_text(file, interrupted);
}

/// Reads a mesh and prints warnings.
/// @param original  gets the file itself, for write_moved_result()
inline mesh_tools::MeshFile read_input(const std::string& path, mesh_tools::OriginalFile* original = nullptr) {
  mesh_tools::MeshFile file = mesh_tools::read_mesh(path, original);
  print_warnings(file.warnings);
  return file;
}

/// The same as flat arrays.
inline mesh_tools::FlatFile read_flat_input(const std::string& path, mesh_tools::SourceFile* source = nullptr) {
  mesh_tools::FlatFile file = mesh_tools::read_flat(path, source);
  print_warnings(file.warnings);
  return file;
}

}  // namespace anisosmooth
