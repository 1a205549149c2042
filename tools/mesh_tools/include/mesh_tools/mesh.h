// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <vcg/complex/complex.h>

namespace mesh_tools {

struct Mesh;

namespace detail {

class VertexD;
class EdgeD;
class FaceD;
struct TypesD
    : vcg::UsedTypes<vcg::Use<VertexD>::AsVertexType, vcg::Use<EdgeD>::AsEdgeType, vcg::Use<FaceD>::AsFaceType> {};
class VertexD
    : public vcg::Vertex<TypesD, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::BitFlags,
                         vcg::vertex::Color4b, vcg::vertex::Qualityd, vcg::vertex::TexCoord2f, vcg::vertex::Radiusf> {};
class EdgeD : public vcg::Edge<TypesD, vcg::edge::VertexRef, vcg::edge::BitFlags> {};
class FaceD : public vcg::Face<TypesD, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::BitFlags,
                               vcg::face::Color4b, vcg::face::Qualityd, vcg::face::WedgeTexCoord2f> {};

}  // namespace detail

/// The mesh of the tools: double precision, with room for every attribute that the file formats carry. Unlike vcglib's
/// meshes it can be moved, so that functions return it; attributes that a caller attached by name do not move along.
struct Mesh : vcg::tri::TriMesh<std::vector<detail::VertexD>, std::vector<detail::EdgeD>, std::vector<detail::FaceD>> {
  Mesh() = default;
  Mesh(Mesh&& other) noexcept { swap(other); }
  Mesh& operator=(Mesh&& other) noexcept {
    swap(other);
    return *this;
  }

 private:
  void swap(Mesh& other) noexcept;
};

/// Average length of the unique edges, |e|; 0 for a mesh without faces. Deleted elements are passed over.
double average_edge_length(const Mesh& mesh);

/// Volume enclosed by the faces, positive if they are oriented outwards; meaningful for closed meshes.
double signed_volume(const Mesh& mesh);

}  // namespace mesh_tools
