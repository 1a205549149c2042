// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <support/flat_mesh.h>

namespace test_support {

/// The neighbourhoods that the library's filter sees, looked at from inside: its own march with its own margin and
/// tolerance, which no public function shows.
class LibraryNeighborhoods {
 public:
  explicit LibraryNeighborhoods(const FlatMesh& mesh);
  ~LibraryNeighborhoods();
  LibraryNeighborhoods(const LibraryNeighborhoods&) = delete;
  LibraryNeighborhoods& operator=(const LibraryNeighborhoods&) = delete;

  /// Vertices with a geodesic distance below `cutoff` (in |e|) from v_i, ascending.
  std::vector<std::size_t> of(std::size_t i, double cutoff);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace test_support
