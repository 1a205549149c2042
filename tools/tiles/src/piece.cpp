// SPDX-License-Identifier: GPL-3.0-or-later
#include "piece.h"

#include <algorithm>
#include <cstring>

#include "bucket_file.h"
#include "index_set.h"

namespace tiles {
namespace {

/// What a tile and its surroundings are made of, as it comes from the buckets.
struct Found {
  BucketPart part;
  std::size_t own_end = 0;  ///< the vertices of the tile itself come first, so many
};

void read_cells(const BucketFile& bucket, const CellSet& cells, BucketPart& part) {
  for (std::size_t begin = 0, end = 0; begin < bucket.cells(); begin = end + 1) {
    end = begin;
    while (end < bucket.cells() && cells.contains(bucket.cell(end))) ++end;
    if (end > begin) bucket.read(begin, end, part);
  }
}

/// Vertices of faces that are not among the given ones.
std::vector<std::uint32_t> other_vertices(const std::vector<BucketFace>& faces, const IndexSet& present) {
  std::vector<std::uint32_t> others;
  for (const BucketFace& face : faces)
    for (const std::uint32_t v : face.vertex)
      if (!present.contains(v)) others.push_back(v);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  return others;
}

}  // namespace

template <class Use>
void PieceReader::for_each_bucket(const CellSet& cells, const Use& use) const {
  std::vector<bool> is_wanted(plan_.tiles());
  for (std::uint32_t cell = 0; cell < plan_.grid.cells(); ++cell)
    if (cells.contains(cell)) is_wanted[cut_.tile_of(cell)] = true;
  for (std::size_t tile = 0; tile < plan_.tiles(); ++tile)
    if (is_wanted[tile]) use(BucketFile(plan_.bucket_path(tile), plan_.real_size));
}

PieceReader::PieceReader(const Plan& plan, const LargeMesh& mesh)
    : plan_(plan), mesh_(mesh), cut_(plan.grid, plan.cut) {}

Piece PieceReader::read(std::size_t tile, double reach) const {
  CellSet own(plan_.grid);
  const BucketFile bucket(plan_.bucket_path(tile), plan_.real_size);
  for (std::size_t i = 0; i < bucket.cells(); ++i) own.add(bucket.cell(i));
  return read(own, reach);
}

Piece PieceReader::read(const CellSet& own, double reach) const {
  Piece piece;
  Found found;
  IndexSet present(plan_.vertices);
  {
    CellSet cells(plan_.grid);
    for_each_bucket(own, [&](const BucketFile& bucket) {
      read_cells(bucket, own, found.part);
      if (reach < 0) return;
      for (std::size_t i = 0; i < bucket.cells(); ++i)
        if (own.contains(bucket.cell(i))) cells.add_around(bucket.cell(i), reach);
    });
    found.own_end = found.part.vertex.size();
    for (const std::uint32_t v : found.part.vertex) present.add(v);
    if (reach >= 0) {
      // Next to the tile there may be vertices that are far away, where edges are long.
      for (const std::uint32_t v : other_vertices(found.part.face, present)) cells.add_around(mesh_.position(v), reach);
      cells.remove(own);
      for_each_bucket(cells, [&](const BucketFile& bucket) { read_cells(bucket, cells, found.part); });
      for (std::size_t i = found.own_end; i < found.part.vertex.size(); ++i) present.add(found.part.vertex[i]);
    }
  }
  piece.own_index.assign(found.part.vertex.begin(),
                         found.part.vertex.begin() + static_cast<std::ptrdiff_t>(found.own_end));
  std::sort(piece.own_index.begin(), piece.own_index.end());
  const std::vector<std::uint32_t> rim = other_vertices(found.part.face, present);
  for (const std::uint32_t v : rim) present.add(v);

  const std::size_t count = present.count();
  piece.own_vertex.resize(count);
  const bool in_floats = plan_.real_size == sizeof(float);
  if (in_floats)
    piece.floats.resize(3 * count);
  else
    piece.doubles.resize(3 * count);
  const std::size_t row = 3 * plan_.real_size;
  char* const positions =
      in_floats ? reinterpret_cast<char*>(piece.floats.data()) : reinterpret_cast<char*>(piece.doubles.data());
  for (std::size_t i = 0; i < found.part.vertex.size(); ++i) {
    const std::size_t place = present.rank(found.part.vertex[i]);
    std::memcpy(positions + place * row, found.part.position.data() + i * row, row);
    piece.own_vertex[place] = i < found.own_end;
  }
  for (const std::uint32_t v : rim) {
    const Point p = mesh_.position(v);
    const std::size_t place = present.rank(v);
    for (std::size_t k = 0; k < 3; ++k) {
      if (in_floats)
        piece.floats[3 * place + k] = static_cast<float>(p[k]);
      else
        piece.doubles[3 * place + k] = p[k];
    }
  }
  std::vector<std::uint32_t>().swap(found.part.vertex);
  std::vector<char>().swap(found.part.position);

  IndexSet faces(plan_.faces);
  for (const BucketFace& face : found.part.face) faces.add(face.index);
  piece.face.resize(faces.count());
  for (const BucketFace& face : found.part.face) {
    Face& local = piece.face[faces.rank(face.index)];
    for (std::size_t k = 0; k < 3; ++k) local[k] = static_cast<std::uint32_t>(present.rank(face.vertex[k]));
  }
  piece.own_face.resize(piece.face.size());
  for (std::size_t f = 0; f < piece.face.size(); ++f)
    piece.own_face[f] = piece.own_vertex[*std::min_element(piece.face[f].begin(), piece.face[f].end())];
  return piece;
}

vcg_core::MeshView view_of(Piece& piece, const Plan& plan) {
  vcg_core::MeshView view =
      piece.floats.empty()
          ? vcg_core::packed_mesh(piece.doubles.data(), piece.vertices(), piece.face.data()->data(), piece.face.size())
          : vcg_core::packed_mesh(piece.floats.data(), piece.vertices(), piece.face.data()->data(), piece.face.size());
  vcg_core::WholeMesh whole;
  whole.average_edge_length = plan.average_edge_length;
  whole.guided = plan.guided;
  for (std::size_t k = 0; k < 3; ++k) {
    whole.box_min[k] = plan.box.min[k];
    whole.box_max[k] = plan.box.max[k];
  }
  view.whole = whole;
  view.counted_vertices.data = piece.own_vertex.data();
  view.counted_faces.data = piece.own_face.data();
  if (!piece.weight.empty()) view.weights = vcg_core::real_rows(piece.weight.data(), sizeof(float));
  return view;
}

void hold_surroundings(Piece& piece) {
  piece.weight.resize(piece.vertices());
  std::copy(piece.own_vertex.begin(), piece.own_vertex.end(), piece.weight.begin());
  std::vector<Point> ring;
  for (const Face& face : piece.face) {
    const auto is_own = [&](std::uint32_t v) { return piece.own_vertex[v] != 0; };
    if (!std::any_of(face.begin(), face.end(), is_own)) continue;
    for (const std::uint32_t v : face)
      if (!is_own(v)) ring.push_back(piece.position(v));
  }
  // By place: of vertices at one place the smallest weight counts.
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  for (std::size_t v = 0; v < piece.vertices(); ++v)
    if (piece.weight[v] == 0 && std::binary_search(ring.begin(), ring.end(), piece.position(v))) piece.weight[v] = 1;
}

}  // namespace tiles
