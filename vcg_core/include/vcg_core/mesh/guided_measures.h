// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <vcg_core/errors.h>
#include <vcg_core/mesh/guided_whole.h>
#include <vcg_core/mesh/mesh_view.h>
#include <vcg_core/mesh/value_counts.h>
#include <vcg_core/progress.h>
#include <vcg_core/smoothing_parameters.h>

namespace vcg_core {

// How the numbers of a GuidedWhole come about when no process holds the whole mesh, in this order: the grid, the noise,
// correlated noise if there is no other, the medians. Functions that get a view throw as smooth() does, and
// InvalidParameter if `guided` is not there.

/// Some vertices of a mesh and some normals of its faces, taken evenly from all of it: about as many as here, or all.
struct VoxelGridSample {
  static constexpr std::size_t usual_vertices = 4096, usual_normals = 65536;

  std::vector<std::array<double, 3>> vertices, normals;
};

/// By each combination of levels, how many vertices of the whole mesh have it: see voxel_levels().
using VoxelLevelCounts = std::array<std::size_t, 9>;

/// Finds the grid of the voxels whose boundary the mesh is. Empty if it is none.
/// @param average_edge_length  |e|
/// @param count                counts the vertices of the whole mesh; is asked seldom unless there is a grid
std::optional<VoxelGrid> find_voxel_grid(const VoxelGridSample& sample, double average_edge_length,
                                         const std::function<VoxelLevelCounts(const VoxelGrid&)>& count);

/// Which levels of the grid a point is on: bit k is set if it is an odd one along axis k. 8: it is not on levels.
unsigned voxel_levels(const std::array<double, 3>& point, const VoxelGrid& grid);

/// What is seen of the noise around a vertex; variances in |e|^2.
struct VertexNoise {
  float variance = 0;    ///< by all vertices around
  float near_by = 0;     ///< by those that are trusted
  float confidence = 0;  ///< whether these are enough: from 0 to 1
};

/// What a piece tells of the noise, over the vertices that count, those at one place as one.
struct NoiseOfPiece {
  GuidedWhole::Testimony testimony;
  std::vector<VertexNoise> vertices;
};

/// @param piece    with what is around it: about 40 rings of vertices add to the numbers of a vertex, the nearer the
///                 more. Of `whole` |e| and the grid are used.
/// @param threads  0: one for each processor; the result does not depend on it
NoiseOfPiece noise_of_piece(const MeshView& piece, const Progress& progress = {}, int threads = 0);

/// The noise of the whole mesh from what all of its vertices tell.
class MeanNoise {
 public:
  /// @param whole  of it the grid, and the testimony of all pieces
  MeanNoise(const GuidedWhole& whole, double average_edge_length);
  void add(const std::vector<VertexNoise>& vertices);
  /// GuidedWhole::noise
  double value() const;

 private:
  GuidedWhole::Testimony testimony_;
  bool has_grid_;
  double average_edge_length_;
  double squares_ = 0;
  std::size_t vertices_ = 0;
};

/// Standard deviation of noise that is correlated over some edges, where the pieces have told of none; 0 if there is
/// none either. Takes as long as smoothing.
/// @param sample   of the mesh, some thousand vertices and more; of `whole` |e| is used, and `guided` has to be there
/// @param threads  0: one for each processor; the result does not depend on it
double correlated_noise(const MeshView& sample, const Progress& progress = {}, int threads = 0);

/// GuidedWhole::medians over the faces and vertices that count.
/// @param view  with all of `whole` but the medians, or with the first of them
std::vector<double> guided_medians(const MeshView& view, const SmoothingParameters& parameters,
                                   const Progress& progress = {});

/// Adds the values that each of these medians is over, those of the piece that count, to `counts`, one after the other.
/// So all pieces together give the medians of the whole. They have to be about known for that, as each round goes by
/// those before it.
/// @param piece  with all of `whole`, and about 16 rings of vertices around what counts
void count_guided_values(const MeshView& piece, const SmoothingParameters& parameters, std::vector<ValueCounts>& counts,
                         const Progress& progress = {});

}  // namespace vcg_core
