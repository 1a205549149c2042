// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <mesh_tools/mesh_io.h>
#include <vcg_core/mesh/mesh_view.h>

namespace anisosmooth {

/// A mesh in the precision of its file, for the core to look at and change: what comes of it is bit for bit what a
/// program with that precision gets. Of single precision, positions and qualities are copies. The file's edges, PLY's
/// element of that name and OBJ's lines, are creases.
class FileView {
 public:
  explicit FileView(mesh_tools::MeshFile& file);

  vcg_core::MeshView& view() { return view_; }

  /// Brings what has changed in the copies back into the mesh.
  void take_back();

 private:
  mesh_tools::Mesh& mesh_;
  vcg_core::MeshView view_;
  std::vector<float> positions_;
  std::vector<float> qualities_;
  std::vector<std::uint64_t> creases_;  // two vertices each
};

}  // namespace anisosmooth
