// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <Eigen/Geometry>

#include "count_intersections.h"
#include "job.h"

#include "face_crossing.h"

namespace vcg_core::detail {

namespace {

using Box = Eigen::AlignedBox3d;

/// A tree of boxes over the faces in their order, which is close in space already: the leaves hold a few faces, each
/// node of a level a few of the level below.
class BoxTree {
 public:
  BoxTree(const MeshArrays& mesh, const Array<Vec3>& position) : count_(mesh.face.size()) {
    Array<Box>& leaves = levels_.emplace_back((count_ + width - 1) / width);
    for (std::size_t f = 0; f < count_; ++f)
      for (const Index v : mesh.face[f]) leaves[f / width].extend(position[v]);
    while (levels_.back().size() > 1) {
      Array<Box> parents((levels_.back().size() + width - 1) / width);
      for (std::size_t i = 0; i < levels_.back().size(); ++i) parents[i / width].extend(levels_.back()[i]);
      levels_.push_back(std::move(parents));
    }
  }

  double largest_coordinate() const {
    const Box& root = levels_.back()[0];
    return std::max(root.min().cwiseAbs().maxCoeff(), root.max().cwiseAbs().maxCoeff());
  }

  /// Calls visit(face) for the faces of all leaves whose box meets `box`, until it says true; whether it did.
  template <class Visit>
  bool any(const Box& box, Visit&& visit) const {
    return any(levels_.size() - 1, 0, box, visit);
  }

 private:
  static constexpr std::size_t width = 4;

  template <class Visit>
  bool any(std::size_t level, std::size_t node, const Box& box, Visit& visit) const {
    if (!levels_[level][node].intersects(box)) return false;
    const std::size_t below = level == 0 ? count_ : levels_[level - 1].size();
    for (std::size_t i = node * width; i < std::min((node + 1) * width, below); ++i)
      if (level == 0 ? visit(i) : any(level - 1, i, box, visit)) return true;
    return false;
  }

  std::size_t count_;
  std::vector<Array<Box>> levels_;  ///< from the leaves to the root
};

Box box_of(const std::array<Index, 3>& face, const Array<Vec3>& position) {
  Box box(position[face[0]]);
  box.extend(position[face[1]]);
  box.extend(position[face[2]]);
  return box;
}

}  // namespace

std::size_t count_self_intersections(const MeshArrays& mesh, const Array<Vec3>& position, Job& job) {
  constexpr std::size_t grain = 1024;
  const BoxTree tree(mesh, position);
  // What rounding leaves uncertain of the largest coordinate, and of the few differences made with it.
  const double rounding = 8 * mesh.coordinate_epsilon * tree.largest_coordinate();
  Array<std::size_t> found((mesh.face.size() + grain - 1) / grain, 0);
  job.parallel(mesh.face.size(), grain, [&](Chunks& chunks) {
    std::size_t tested = 0;
    while (chunks.next())
      for (std::size_t f = chunks.begin(); f < chunks.end(); ++f) {
        const PlacedFace face = place_face(mesh.face[f], position);
        const Box box = box_of(mesh.face[f], position);
        found[chunks.index()] += tree.any(box, [&](std::size_t other) {
          if (++tested % 4096 == 0) chunks.poll();
          return other != f && box.intersects(box_of(mesh.face[other], position)) &&
                 faces_cross(face, place_face(mesh.face[other], position), rounding);
        });
      }
  });
  std::size_t sum = 0;
  for (const std::size_t n : found) sum += n;
  return sum;
}

}  // namespace vcg_core::detail
