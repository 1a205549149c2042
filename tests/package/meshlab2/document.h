// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <vcg/complex/complex.h>

// A mesh of the documented kind: single precision, with optional components in arrays beside the elements.
class Vertex2;
class Face2;
struct Types2 : vcg::UsedTypes<vcg::Use<Vertex2>::AsVertexType, vcg::Use<Face2>::AsFaceType> {};
class Vertex2 : public vcg::Vertex<Types2, vcg::vertex::InfoOcf, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
                                   vcg::vertex::Color4b, vcg::vertex::Qualityf, vcg::vertex::BitFlags,
                                   vcg::vertex::TexCoordfOcf, vcg::vertex::VFAdjOcf> {};
class Face2
    : public vcg::Face<Types2, vcg::face::InfoOcf, vcg::face::VertexRef, vcg::face::Normal3f, vcg::face::Color4b,
                       vcg::face::Qualityf, vcg::face::BitFlags, vcg::face::FFAdjOcf, vcg::face::VFAdjOcf> {};
class VCGMesh : public vcg::tri::TriMesh<vcg::vertex::vector_ocf<Vertex2>, vcg::face::vector_ocf<Face2>> {};

class Document {
 public:
  struct MeshEntry {
    VCGMesh mesh;
  };
  int currentMeshIndex() const { return 0; }
  MeshEntry& mesh(int) { return entry_; }
  vcg::CallBackPos* progressCallback() { return callback; }
  void markMeshGeometryChanged(int, const QString& = {}) { ++changes; }

  vcg::CallBackPos* callback = nullptr;
  int changes = 0;

 private:
  MeshEntry entry_;
};
