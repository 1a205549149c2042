// SPDX-License-Identifier: GPL-3.0-or-later
#include "decimation.h"

#include <array>
#include <vector>

#include <vcg/complex/algorithms/local_optimization.h>
#include <vcg/complex/algorithms/local_optimization/tri_edge_collapse_quadric.h>

#include "training_mesh.h"

namespace training {

namespace {

class DecimatedVertex;
class DecimatedEdge;
class DecimatedFace;
struct DecimatedTypes : vcg::UsedTypes<vcg::Use<DecimatedVertex>::AsVertexType, vcg::Use<DecimatedEdge>::AsEdgeType,
                                       vcg::Use<DecimatedFace>::AsFaceType> {};
class DecimatedVertex : public vcg::Vertex<DecimatedTypes, vcg::vertex::VFAdj, vcg::vertex::Coord3d,
                                           vcg::vertex::Normal3d, vcg::vertex::Mark, vcg::vertex::BitFlags> {
 public:
  vcg::math::Quadric<double>& Qd() { return quadric_; }

 private:
  vcg::math::Quadric<double> quadric_;
};
class DecimatedEdge : public vcg::Edge<DecimatedTypes> {};
class DecimatedFace : public vcg::Face<DecimatedTypes, vcg::face::VFAdj, vcg::face::VertexRef, vcg::face::BitFlags> {};
class DecimatedMesh : public vcg::tri::TriMesh<std::vector<DecimatedVertex>, std::vector<DecimatedFace>> {};

using Pair = vcg::tri::BasicVertexPair<DecimatedVertex>;
class Collapse
    : public vcg::tri::TriEdgeCollapseQuadric<DecimatedMesh, Pair, Collapse, vcg::tri::QInfoStandard<DecimatedVertex>> {
 public:
  using Base =
      vcg::tri::TriEdgeCollapseQuadric<DecimatedMesh, Pair, Collapse, vcg::tri::QInfoStandard<DecimatedVertex>>;
  Collapse(const Pair& pair, int mark, vcg::BaseParameterClass* parameters) : Base(pair, mark, parameters) {}
};

}  // namespace

void decimate(mesh_tools::Mesh& mesh, double share, mesh_tools::Random& random) {
  DecimatedMesh work;
  vcg::tri::Allocator<DecimatedMesh>::AddVertices(work, mesh.vert.size());
  vcg::tri::Allocator<DecimatedMesh>::AddFaces(work, mesh.face.size());
  // Noise that only the order of collapses sees; without it a plane would be stripped to its outline.
  const double unrest = between(random, 0.02, 0.2) * mesh_tools::average_edge_length(mesh);
  std::vector<vcg::Point3d> original;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    original.push_back(mesh.vert[v].P());
    work.vert[v].P() = mesh.vert[v].P() + random.direction() * (unrest * random.normal());
  }
  for (std::size_t f = 0; f < mesh.face.size(); ++f)
    for (int k = 0; k < 3; ++k) work.face[f].V(k) = &work.vert[vcg::tri::Index(mesh, mesh.face[f].V(k))];
  vcg::tri::UpdateTopology<DecimatedMesh>::VertexFace(work);
  vcg::tri::UpdateBounding<DecimatedMesh>::Box(work);

  vcg::tri::TriEdgeCollapseQuadricParameter parameters;
  parameters.OptimalPlacement = false;  // vertices stay on the surface
  parameters.NormalCheck = true;
  parameters.PreserveTopology = true;
  parameters.PreserveBoundary = true;
  vcg::LocalOptimization<DecimatedMesh> optimization(work, &parameters);
  optimization.Init<Collapse>();
  optimization.SetTargetSimplices(static_cast<int>(share * static_cast<double>(mesh.face.size())));
  optimization.SetTimeBudget(10.0F);
  optimization.DoOptimization();
  optimization.Finalize<Collapse>();

  std::vector<std::array<std::size_t, 3>> faces;
  for (auto& f : work.face)
    if (!f.IsD())
      faces.push_back({vcg::tri::Index(work, f.V(0)), vcg::tri::Index(work, f.V(1)), vcg::tri::Index(work, f.V(2))});
  build(mesh, original, faces);
}

}  // namespace training
