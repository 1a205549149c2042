// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "group_order.h"
#include "patch.h"
#include "ring.h"
#include "source_groups.h"
#include "sparse_index_map.h"

namespace vcg_core::detail {

/// What the patches of one pass are cut out of.
struct LaneMesh {
  const MeshArrays& mesh;
  const Rings& ring;
  const SourceGroups& groups;
  const Array<Vec3>& position;  ///< in units of MeshArrays::position
  const Array<Vec3>& normal;
};

/// Cuts out of the mesh what a few groups of sources need. One a thread; its memory is reused from patch to patch.
class PatchBuilder {
 public:
  PatchBuilder(const LaneMesh& lanes, const LaneKernel& kernel);

  /// The patch of the groups [first, last), see patch_groups.
  /// @param reach  distance from a source, in |e|, up to which vertices are wanted
  /// @param poll   called now and then, as a patch may be the whole mesh; may throw
  const Patch& build(std::size_t first, std::size_t last, double reach, const std::function<void()>& poll = {});

  /// One of the patch's groups; valid until the next.
  const PatchGroup& group(std::size_t g);

  /// The mesh's vertex at a row of the last patch.
  Index vertex(std::uint32_t row) const { return rows_[row].vertex; }

 private:
  struct Row {
    Index vertex;
    float place[3];
  };
  static constexpr std::uint32_t unknown = SparseIndexMap::none;
  static constexpr std::uint32_t outside = unknown - 1;

  void forget_last();
  void place_sources();
  GroupBall ball_around(const Row* source, std::size_t count) const;
  void collect_rows(const std::function<void()>& poll);
  Row row_at(Index vertex) const;
  void consider(Index vertex);
  void place_rows();
  void reserve_faces(std::size_t faces);
  void place_face(std::uint32_t f, std::uint32_t row, const RingFace& ring_face);
  void reserve_kernel_memory();

  const LaneMesh& lanes_;
  std::uint32_t lane_count_;
  double per_unit_;
  Patch patch_{};
  std::size_t first_group_ = 0;
  std::size_t last_group_ = 0;
  float reach_ = 0;
  Vec3 middle_;
  std::vector<GroupBall> ball_;  ///< by group of the patch
  std::size_t last_near_ = 0;    ///< the ball that held the last row found, and probably holds the next
  GroupOrder order_;
  std::vector<std::uint32_t> source_row_;  ///< by source of the patch
  SparseIndexMap row_of_;                  ///< by vertex of the mesh: its row, or `unknown`, or `outside`
  std::vector<Row> rows_;                  ///< sources first, then as they are found
  std::vector<float> place_[3];
  std::vector<float> normal_[3];
  std::vector<std::uint32_t> face_begin_;
  std::vector<std::uint32_t> apex_;
  std::vector<std::uint32_t> row_1_;
  std::vector<std::uint32_t> row_2_;
  std::vector<FaceMarks> marks_;
  std::vector<FaceShape> shape_;
  std::vector<float> distance_;
  std::vector<std::uint32_t> pending_;
};

}  // namespace vcg_core::detail
