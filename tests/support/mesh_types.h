// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg/complex/complex.h>

namespace test_support {

// The kinds of vcglib mesh that callers come with. vcglib's meshes name their element types through a class of used
// types, hence three declarations for each.

/// Positions and nothing else: no flags, so no selection and nothing deleted.
class BareVertex;
class BareFace;
struct BareTypes : vcg::UsedTypes<vcg::Use<BareVertex>::AsVertexType, vcg::Use<BareFace>::AsFaceType> {};
class BareVertex : public vcg::Vertex<BareTypes, vcg::vertex::Coord3d> {};
class BareFace : public vcg::Face<BareTypes, vcg::face::VertexRef> {};
struct BareMesh : vcg::tri::TriMesh<std::vector<BareVertex>, std::vector<BareFace>> {};

/// Positions and flags in double precision: what most tests use.
class DoubleVertex;
class DoubleFace;
struct DoubleTypes : vcg::UsedTypes<vcg::Use<DoubleVertex>::AsVertexType, vcg::Use<DoubleFace>::AsFaceType> {};
class DoubleVertex : public vcg::Vertex<DoubleTypes, vcg::vertex::Coord3d, vcg::vertex::BitFlags> {};
class DoubleFace : public vcg::Face<DoubleTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
struct DoubleMesh : vcg::tri::TriMesh<std::vector<DoubleVertex>, std::vector<DoubleFace>> {};

/// The same in single precision.
class FloatVertex;
class FloatFace;
struct FloatTypes : vcg::UsedTypes<vcg::Use<FloatVertex>::AsVertexType, vcg::Use<FloatFace>::AsFaceType> {};
class FloatVertex : public vcg::Vertex<FloatTypes, vcg::vertex::Coord3f, vcg::vertex::BitFlags> {};
class FloatFace : public vcg::Face<FloatTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
struct FloatMesh : vcg::tri::TriMesh<std::vector<FloatVertex>, std::vector<FloatFace>> {};

/// Attributes and adjacency stored in the elements, which makes them large and the stride between positions odd.
class RichVertex;
class RichEdge;
class RichFace;
struct RichTypes : vcg::UsedTypes<vcg::Use<RichVertex>::AsVertexType, vcg::Use<RichEdge>::AsEdgeType,
                                  vcg::Use<RichFace>::AsFaceType> {};
class RichVertex : public vcg::Vertex<RichTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::BitFlags,
                                      vcg::vertex::Color4b, vcg::vertex::Qualityd, vcg::vertex::TexCoord2f,
                                      vcg::vertex::VFAdj, vcg::vertex::Mark> {};
class RichEdge : public vcg::Edge<RichTypes, vcg::edge::VertexRef, vcg::edge::BitFlags> {};
class RichFace : public vcg::Face<RichTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::BitFlags,
                                  vcg::face::Color4b, vcg::face::FFAdj, vcg::face::VFAdj, vcg::face::Mark> {};
struct RichMesh : vcg::tri::TriMesh<std::vector<RichVertex>, std::vector<RichEdge>, std::vector<RichFace>> {};

/// Optional components ("OCF"), as in MeshLab's own mesh.
class OcfVertex;
class OcfEdge;
class OcfFace;
struct OcfTypes
    : vcg::UsedTypes<vcg::Use<OcfVertex>::AsVertexType, vcg::Use<OcfEdge>::AsEdgeType, vcg::Use<OcfFace>::AsFaceType> {
};
class OcfVertex : public vcg::Vertex<OcfTypes, vcg::vertex::InfoOcf, vcg::vertex::Coord3f, vcg::vertex::BitFlags,
                                     vcg::vertex::Normal3f, vcg::vertex::Qualityf, vcg::vertex::Color4b,
                                     vcg::vertex::VFAdjOcf, vcg::vertex::MarkOcf, vcg::vertex::TexCoordfOcf> {};
class OcfEdge : public vcg::Edge<OcfTypes, vcg::edge::VertexRef, vcg::edge::BitFlags> {};
class OcfFace : public vcg::Face<OcfTypes, vcg::face::InfoOcf, vcg::face::VertexRef, vcg::face::BitFlags,
                                 vcg::face::Normal3f, vcg::face::QualityfOcf, vcg::face::MarkOcf, vcg::face::FFAdjOcf,
                                 vcg::face::VFAdjOcf, vcg::face::WedgeTexCoordfOcf> {};
struct OcfMesh
    : vcg::tri::TriMesh<vcg::vertex::vector_ocf<OcfVertex>, std::vector<OcfEdge>, vcg::face::vector_ocf<OcfFace>> {};

}  // namespace test_support
