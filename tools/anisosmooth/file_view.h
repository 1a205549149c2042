// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <mesh_tools/mesh_io.h>
#include <vcg_core/mesh/mesh_view.h>

namespace anisosmooth {

/// A mesh in the precision of its file, for the core to look at and change in place: what comes of it is bit for bit
/// what a program with that precision gets. What the mesh itself has in another precision is copied. The file's edges,
/// PLY's element of that name and OBJ's lines, are creases.
class FileView {
 public:
  explicit FileView(mesh_tools::FlatFile& file);

  vcg_core::MeshView& view() { return view_; }

  /// Brings what has changed in the copies back into the mesh.
  void take_back();

 private:
  mesh_tools::FlatMesh& mesh_;
  vcg_core::MeshView view_;
  std::vector<float> positions_;
  std::vector<float> qualities_;
};

}  // namespace anisosmooth
