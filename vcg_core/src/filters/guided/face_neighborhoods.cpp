// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_neighborhoods.h"

#include <algorithm>
#include <vector>

#include "job.h"
#include "mesh/creases.h"
#include "sparse_index_map.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 2048;

/// A vertex with more faces than this, say the tip of a finely cut cone, would make lists of quadratic length.
constexpr std::size_t many_faces = 48;

/// No neighbourhood holds more faces: on very uneven meshes a ball can hold any number of tiny ones.
constexpr std::size_t most_faces = 200;

std::size_t faces_of(const MeshTopology& topology, Index v) {
  return topology.star_begin[v + 1] - topology.star_begin[v];
}

/// Makes room for what a list will hold in the end by what its first part holds.
void reserve_for_all(std::size_t part, std::size_t of, std::size_t needed, Array<Index>& list) {
  constexpr double allowance = 1.05;
  if (list.capacity() >= needed) return;
  const double expected = allowance * static_cast<double>(needed) / static_cast<double>(part) * static_cast<double>(of);
  list.reserve(std::max(needed, static_cast<std::size_t>(expected)));
}

/// Adds the lists of `count` faces from `first` on.
template <class Append>
void add_lists(std::size_t first, std::size_t count, std::size_t faces, Job& job, const Append& append,
               FaceLists& lists) {
  const std::size_t chunk_count = (count + grain - 1) / grain;
  std::vector<Array<Index>> part(chunk_count);
  job.parallel(count, grain, Loop::minor, [&](Chunks& chunks) {
    FaceMarks marks(faces);
    while (chunks.next()) {
      Array<Index>& list = part[chunks.index()];
      marks.forget_all();
      for (std::size_t f = first + chunks.begin(); f < first + chunks.end(); ++f) {
        const std::size_t before = list.size();
        marks.begin(static_cast<Index>(f));
        append(static_cast<Index>(f), marks, list);
        lists.begin[f + 1] = list.size() - before;
      }
    }
  });
  job.serial(count, [&](std::size_t i) { lists.begin[first + i + 1] += lists.begin[first + i]; });
  const std::size_t end = lists.begin[first + count];
  reserve_for_all(first + count, faces, end, lists.face);
  lists.face.resize(end);
  job.parallel(chunk_count, 1, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t c = chunks.begin(); c < chunks.end(); ++c)
        std::copy(part[c].begin(), part[c].end(),
                  lists.face.begin() + static_cast<std::ptrdiff_t>(lists.begin[first + c * grain]));
  });
}

/// Makes lists in parallel: `append(f, marks, list)` adds those of one face to the end of its chunk's list. One stretch
/// of the faces after the other, so that little is in memory twice.
template <class Append>
FaceLists make_lists(std::size_t faces, Job& job, const Append& append) {
  constexpr std::size_t stretches = 16, fewest_chunks = 64;
  const std::size_t stretch = std::max(fewest_chunks, faces / stretches / grain + 1) * grain;
  FaceLists lists;
  lists.begin.assign(faces + 1, 0);
  for (std::size_t first = 0; first < faces; first += stretch)
    add_lists(first, std::min(stretch, faces - first), faces, job, append, lists);
  return lists;
}

/// Sum and number of lengths, over the edges at v as its faces see them: inner ones twice.
double mean_edge_length(const MeshArrays& mesh, Index v, double otherwise) {
  const MeshTopology& topology = mesh.topology;
  double sum = 0;
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
    const Index corner = topology.star[s];
    sum += (mesh.position[vertex_of(mesh, next_in_face(corner))] - mesh.position[v]).norm();
    sum += (mesh.position[vertex_of(mesh, previous_in_face(corner))] - mesh.position[v]).norm();
  }
  const std::size_t count = 2 * faces_of(topology, v);
  return count > 0 ? sum / static_cast<double>(count) : otherwise;
}

Array<double> mean_over_ring(const MeshArrays& mesh, const Array<double>& value, Job& job) {
  const MeshTopology& topology = mesh.topology;
  Array<double> mean(mesh.size());
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
        double sum = value[v];
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
          const Index corner = topology.star[s];
          sum += value[vertex_of(mesh, next_in_face(corner))] + value[vertex_of(mesh, previous_in_face(corner))];
        }
        mean[v] = sum / static_cast<double>(1 + 2 * faces_of(topology, static_cast<Index>(v)));
      }
  });
  return mean;
}

}  // namespace

Array<Index> faces_across(const MeshArrays& mesh, Job& job) {
  struct Side {
    Index end;     ///< the edge's other vertex, of higher index
    Index corner;  ///< opposite to the edge
  };
  const MeshTopology& topology = mesh.topology;
  Array<Index> across(3 * mesh.face.size(), no_face);
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    std::vector<Side> sides;
    while (chunks.next())
      for (auto v = static_cast<Index>(chunks.begin()); v < chunks.end(); ++v) {
        sides.clear();
        for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) {
          const Index corner = topology.star[s];
          const Index next = next_in_face(corner);
          const Index previous = previous_in_face(corner);
          if (vertex_of(mesh, next) > v) sides.push_back({vertex_of(mesh, next), previous});
          if (vertex_of(mesh, previous) > v) sides.push_back({vertex_of(mesh, previous), next});
        }
        std::sort(sides.begin(), sides.end(),
                  [](const Side& a, const Side& b) { return a.end != b.end ? a.end < b.end : a.corner < b.corner; });
        for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
          while (end < sides.size() && sides[end].end == sides[begin].end) ++end;
          if (end - begin != 2) continue;
          if (!topology.crease.empty() && topology.crease[sides[begin].corner]) continue;
          across[sides[begin].corner] = sides[begin + 1].corner / 3;
          across[sides[begin + 1].corner] = sides[begin].corner / 3;
        }
      }
  });
  return across;
}

namespace {

/// Adds them to the end of a list.
void append_faces_around(const MeshArrays& mesh, const Array<Index>& across, Index f, FaceMarks& marks,
                         Array<Index>& list) {
  const MeshTopology& topology = mesh.topology;
  const auto add = [&](Index g) {
    if (g != no_face && marks.add(g)) list.push_back(g);
  };
  add(f);
  for (int k = 0; k < 3; ++k) add(across[3 * f + static_cast<Index>(k)]);
  for (Index k = 0; k < 3; ++k) {
    const Index v = mesh.face[f][k];
    if (faces_of(topology, v) > many_faces) continue;
    if (topology.is_on_crease(v)) {
      Array<Index> sector;
      add_faces_of_sector(mesh, v, 3 * f + k, sector);
      for (const Index g : sector) add(g);
      continue;
    }
    for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s) add(topology.star[s] / 3);
  }
}

}  // namespace

FaceLists faces_around(const MeshArrays& mesh, const Array<Index>& across, Job& job) {
  return make_lists(mesh.face.size(), job, [&](Index f, FaceMarks& marks, Array<Index>& list) {
    append_faces_around(mesh, across, f, marks, list);
  });
}

FacesAround::FacesAround(const MeshArrays& mesh, const Array<Index>& across)
    : mesh_(mesh), across_(across), marks_(mesh.face.size()) {}

const Array<Index>& FacesAround::find(Index f) {
  list_.clear();
  marks_.begin(f);
  append_faces_around(mesh_, across_, f, marks_, list_);
  return list_;
}

Array<double> local_spacing(const MeshArrays& mesh, bool follow_edge_length, double least, Job& job) {
  constexpr int rings = 3;
  constexpr double centroids_per_edge = 0.6;  // about: 1 / sqrt(3) between equilateral triangles
  constexpr double shortest = 1e-6;           // |e|; a neighbourhood has an extent even where all vertices coincide
  const double e = mesh.topology.average_edge_length;
  Array<double> spacing(mesh.face.size(), centroids_per_edge * e);
  if (!follow_edge_length) return spacing;
  const double limit = std::max(std::min(least, centroids_per_edge * e), shortest * e);
  Array<double> length(mesh.size());
  job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t v = chunks.begin(); v < chunks.end(); ++v)
        length[v] = mean_edge_length(mesh, static_cast<Index>(v), e);
  });
  for (int ring = 0; ring < rings; ++ring) length = mean_over_ring(mesh, length, job);
  job.serial(spacing.size(), [&](std::size_t f) {
    const auto& v = mesh.face[f];
    spacing[f] = std::max(centroids_per_edge * (length[v[0]] + length[v[1]] + length[v[2]]) / 3, limit);
  });
  return spacing;
}

FaceLists faces_within(const FaceLists& around, const Array<Vec3>& centroid, const Array<double>& spacing,
                       double radius, Job& job) {
  constexpr std::size_t fewest = 4;
  return make_lists(centroid.size(), job, [&](Index f, FaceMarks& marks, Array<Index>& list) {
    const std::size_t begin = list.size();
    const double limit = radius * spacing[f] * radius * spacing[f];
    marks.add(f);
    list.push_back(f);
    for (std::size_t k = begin; k < list.size() && list.size() - begin < most_faces; ++k) {
      const Index g = list[k];
      for (const Index* h = around.first(g); h != around.last(g); ++h)
        if (marks.add(*h) && (centroid[*h] - centroid[f]).squaredNorm() < limit) list.push_back(*h);
    }
    if (list.size() - begin < fewest)
      for (const Index* h = around.first(f); h != around.last(f); ++h)
        if (std::find(list.begin() + static_cast<std::ptrdiff_t>(begin), list.end(), *h) == list.end())
          list.push_back(*h);
  });
}

}  // namespace vcg_core::detail
