// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <vcg_core/mesh/mesh_view.h>

#include "cell_set.h"
#include "cut.h"
#include "large_mesh.h"
#include "plan.h"

namespace tiles {

/// A tile, or other cells, and the surroundings as a mesh in memory. Vertices and faces are in the order of the file.
struct Piece {
  std::vector<float> floats;    ///< the positions, if the file has single precision
  std::vector<double> doubles;  ///< otherwise
  std::vector<Face> face;
  std::vector<std::uint8_t> own_vertex;  ///< whether it belongs to the tile
  std::vector<std::uint8_t> own_face;    ///< the tile has the first of its vertices in the order of the file
  std::vector<std::uint32_t> own_index;  ///< of the tile's vertices, as the file counts them
  std::vector<float> weight;             ///< 0 for vertices that need not move; may be empty

  std::size_t vertices() const { return own_vertex.size(); }
  Point position(std::size_t v) const {
    Point p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = floats.empty() ? doubles[3 * v + k] : static_cast<double>(floats[3 * v + k]);
    return p;
  }
  std::vector<double> positions() const {
    return floats.empty() ? doubles : std::vector<double>(floats.begin(), floats.end());
  }
};

/// Reads pieces of a mesh that is cut.
class PieceReader {
 public:
  /// @param plan  referred to; of it what describes the cut
  PieceReader(const Plan& plan, const LargeMesh& mesh);

  /// The vertices of a tile, all faces that touch them, and all vertices and faces that these depend on.
  /// @param reach  how far their positions depend on others; less than 0: only the faces that touch the tile
  Piece read(std::size_t tile, double reach) const;
  /// The same of any cells.
  Piece read(const CellSet& own, double reach) const;

 private:
  /// Calls use(bucket) for each bucket that some of the cells belong to.
  template <class Use>
  void for_each_bucket(const CellSet& cells, const Use& use) const;

  const Plan& plan_;
  const LargeMesh& mesh_;
  Cut cut_;
};

/// The piece as the core sees it. Refers to it.
vcg_core::MeshView view_of(Piece& piece, const Plan& plan);

/// Lets only the vertices of the tile move, and those next to them, whose new places the figures of its faces need.
void hold_surroundings(Piece& piece);

}  // namespace tiles
