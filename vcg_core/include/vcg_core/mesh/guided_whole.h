// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace vcg_core {

/// The grid of a binary volume whose boundary a mesh is, as marching cubes made it: see docs/guided.md.
struct VoxelGrid {
  double axis[3][3] = {};    ///< orthogonal unit vectors, nearest to x, y and z
  double first[3] = {};      ///< along each axis, the coordinate of a level; levels hold the vertices
  double distance[3] = {};   ///< from one level to the next: half the distance of two voxels
  unsigned odd_centres = 0;  ///< bit k: along axis k the voxels' centres are on the odd levels
};

/// What the guided filter knows of the whole mesh besides WholeMesh's own. A run over a whole mesh measures it; a piece
/// is told it, so that its vertices come out as they do in the whole. Made by the functions of guided_measures.h.
struct GuidedWhole {
  /// What speaks for noise, over all vertices: sums, so that those of pieces add up.
  struct Testimony {
    double opposed = 0;   ///< products of opposed heights of neighbours, where they are trusted; a squared length
    double expected = 0;  ///< what noise of standard deviation 1 would give there
    double trusted = 0;   ///< vertices, each as far as it is trusted
    double asked = 0;     ///< vertices
  };

  std::optional<VoxelGrid> grid;  ///< empty: the mesh is no boundary of voxels
  Testimony testimony;            ///< not of a mesh with a grid
  double noise = 0;               ///< root of the mean square of the vertices' standard deviations, a length
  bool correlated = false;        ///< the noise is correlated over some edges, and the same everywhere
  /// Medians over the mesh, in the order in which a run asks for them, lengths in |e|. Fewer than it asks for: those
  /// that are missing are measured over the piece.
  std::vector<double> medians;
};

}  // namespace vcg_core
