#pragma once

#include <limits>
#include <vector>

#include "patch.h"
#include "ring.h"

namespace vcg_core::detail {

/// What the patches of one pass are cut out of.
struct LaneMesh {
  const MeshArrays& mesh;
  const std::vector<RingFace>& ring;
  const std::vector<Vec3>& position;  ///< in units of MeshArrays::position
  const std::vector<Vec3>& normal;
};

/// Cuts out of the mesh what a group of sources needs. One a thread; its memory is reused from patch to patch.
class PatchBuilder {
 public:
  PatchBuilder(const LaneMesh& lanes, std::uint32_t lane_count);

  /// @param reach  distance from a source, in |e|, up to which vertices are wanted
  const Patch& build(const Index* sources, std::uint32_t count, double reach);

  /// The mesh's vertex at a row of the last patch.
  Index vertex(std::uint32_t row) const { return rows_[row].vertex; }

 private:
  struct Row {
    Index vertex;
    float place[3];
    float squared_radius;
  };
  static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t outside = unknown - 1;

  void forget_last();
  void place_sources(const Index* sources, std::uint32_t count);
  void collect_rows(const Index* sources, std::uint32_t count, double reach);
  Row row_at(Index vertex) const;
  void consider(Index vertex);
  void sort_rows();
  void place_rows();
  void place_faces();
  void add_face(std::uint32_t row, std::uint32_t slot, const RingFace& ring_face);
  void reserve_kernel_memory();

  const LaneMesh& lanes_;
  std::uint32_t lane_count_;
  double per_unit_;
  Patch patch_{};
  Vec3 middle_;
  float source_place_[3][most_lanes];  ///< unused lanes repeat the first source
  float squared_reach_;
  std::vector<std::uint32_t> row_of_;  ///< by vertex of the mesh: its row in the patch, or `unknown`, or `outside`
  std::vector<Row> found_;
  std::vector<Index> found_outside_;
  std::vector<Row> rows_;
  std::vector<std::uint32_t> bucket_begin_;
  std::vector<float> squared_radius_;
  std::vector<float> place_[3];
  std::vector<float> normal_[3];
  std::vector<std::uint32_t> face_begin_;
  std::vector<std::uint32_t> ready_faces_;
  std::vector<std::uint32_t> apex_;
  std::vector<std::uint32_t> row_1_;
  std::vector<std::uint32_t> row_2_;
  std::vector<FaceMarks> marks_;
  std::uint32_t source_row_[most_lanes];
  std::vector<FaceShape> shape_;
  std::vector<float> distance_;
  std::vector<std::uint32_t> pending_;
  std::vector<std::uint64_t> dirty_;
};

}  // namespace vcg_core::detail
