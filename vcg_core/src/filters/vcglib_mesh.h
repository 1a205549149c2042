// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <vcg/complex/complex.h>

#include <vcg/complex/algorithms/smooth.h>  // needs complex.h before it

#include "filters/filter.h"
#include "job.h"

namespace vcg_core::detail {

// A mesh type of our own, in double precision: vcglib's templates over it are nobody else's, so that a program with
// compiled copies of vcglib, such as MeshLab, cannot interfere.
class SmoothedVertex;
class SmoothedFace;
struct SmoothedTypes : vcg::UsedTypes<vcg::Use<SmoothedVertex>::AsVertexType, vcg::Use<SmoothedFace>::AsFaceType> {};
class SmoothedVertex : public vcg::Vertex<SmoothedTypes, vcg::vertex::Coord3d, vcg::vertex::BitFlags> {};
class SmoothedFace : public vcg::Face<SmoothedTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class SmoothedMesh : public vcg::tri::TriMesh<std::vector<SmoothedVertex>, std::vector<SmoothedFace>> {};

/// The mesh that vcglib's own smoothers work on, made so that their weaknesses do no harm: they divide by zero at
/// vertices without faces, so those are left out, and so are faces with a repeated vertex; they know no fixed vertices,
/// so the movable ones are selected and only these are read back.
class VcglibMesh {
 public:
  VcglibMesh(const MeshArrays& arrays, Job& job);

  SmoothedMesh& mesh() { return mesh_; }

  /// Brings the positions into the mesh, and selects the movable vertices.
  void load(const PassInput& in);
  Array<Vec3> positions(const PassInput& in) const;

  bool has_movable_border() const { return has_movable_border_; }

  /// Runs `step` on the mesh. Afterwards multiplies how far each selected border vertex went by factor(k), k being the
  /// number of border edges there.
  template <class Step, class Factor>
  void step_scaling_borders(Step&& step, Factor&& factor) {
    std::vector<vcg::Point3d> before;
    if (has_movable_border_)
      for (const Index v : border_) before.push_back(mesh_.vert[v].P());
    step(mesh_);
    if (!has_movable_border_) return;
    for (std::size_t b = 0; b < border_.size(); ++b) {
      SmoothedVertex& vertex = mesh_.vert[border_[b]];
      if (vertex.IsS()) vertex.P() = before[b] + (vertex.P() - before[b]) * factor(border_edges_[b]);
    }
  }

 private:
  void find_borders(Job& job);

  SmoothedMesh mesh_;
  Array<Index> vertex_;         ///< index in the arrays of each vertex of mesh_
  Array<Index> border_;         ///< the vertices of mesh_ on border edges
  Array<double> border_edges_;  ///< how many, for each of them
  bool has_movable_border_ = false;
};

/// A pass that calls step(VcglibMesh&) on a mesh that is kept from pass to pass.
template <class Step>
FilterPass make_vcglib_pass(Step step) {
  return [step, mesh = std::shared_ptr<VcglibMesh>()](const PassInput& in) mutable {
    if (!mesh) mesh = std::make_shared<VcglibMesh>(in.mesh, in.job);
    mesh->load(in);
    in.job.report(0.1);
    step(*mesh);
    return PassOutput{mesh->positions(in)};
  };
}

}  // namespace vcg_core::detail
