// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <mesh_tools/mesh.h>

namespace anisosmooth {

/// While it lives, vertices that no face or edge uses and that have no finite place are marked as deleted, so that the
/// filters, which refuse such places, pass over them.
class HiddenVertices {
 public:
  explicit HiddenVertices(mesh_tools::Mesh& mesh);
  ~HiddenVertices();
  HiddenVertices(const HiddenVertices&) = delete;
  HiddenVertices& operator=(const HiddenVertices&) = delete;

  std::size_t count() const { return hidden_.size(); }

 private:
  mesh_tools::Mesh& mesh_;
  std::vector<std::size_t> hidden_;
};

}  // namespace anisosmooth
