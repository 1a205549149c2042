// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld.h"

#include <algorithm>
#include <utility>

#include <vcg_core/errors.h>

#include "job.h"
#include "point_grid.h"

namespace vcg_core::detail {

namespace {

/// Points that one search may look at in the mean. Near any sensible distance there are a few.
constexpr std::size_t most_looks = 1000;

constexpr std::size_t looks_between_polls = std::size_t(1) << 20;

/// Sets of points, each known by its first one.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    for (std::size_t i = 0; i < size; ++i) parent_[i] = static_cast<Index>(i);
  }

  Index first_of(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(Index a, Index b) {
    a = first_of(a);
    b = first_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  Array<Index> parent_;
};

Welding weld_equal(const Array<Vec3>& position, const Array<Index>& order, Job& job) {
  Welding welding{Array<Index>(order.size()), 0};
  job.serial(order.size(), [&](std::size_t i) {
    welding.vertices += i == 0 || position[order[i]] != position[order[i - 1]];
    welding.vertex[i] = static_cast<Index>(welding.vertices - 1);
  });
  return welding;
}

[[noreturn]] void refuse_distance() {
  throw InvalidParameter(
      "weld_distance is so large that it would join most of the mesh; it must be well below the lengths of the edges");
}

/// Joins the vertices of `welding` that lie near each other.
void weld_near(const Array<Vec3>& position, const Array<Index>& order, double distance, Welding& welding, Job& job) {
  Array<Vec3> place(welding.vertices);
  Array<Index> vertices(welding.vertices);
  job.serial(order.size(), [&](std::size_t i) { place[welding.vertex[i]] = position[order[i]]; });
  job.serial(vertices.size(), [&](std::size_t v) { vertices[v] = static_cast<Index>(v); });
  const PointGrid grid(place, vertices, distance * (1 + 1e-9), &job);  // finds what is nearer, and not what is as far
  PointGrid::Search search(grid);
  DisjointSets sets(place.size());
  std::size_t looks_at_poll = 0;
  job.serial(place.size(), [&](std::size_t v) {
    search.for_each_near(place[v], [&](Index w, const Vec3& other) {
      if (w > v && (other - place[v]).squaredNorm() <= distance * distance) sets.join(static_cast<Index>(v), w);
    });
    if (search.looks() / most_looks > place.size()) refuse_distance();
    if (search.looks() - looks_at_poll > looks_between_polls) {
      job.poll();
      looks_at_poll = search.looks();
    }
  });
  Array<Index>& number = vertices;  // of each set: they count up from the first set
  std::size_t count = 0;
  job.serial(place.size(), [&](std::size_t v) {
    const Index first = sets.first_of(static_cast<Index>(v));
    number[v] = first == v ? static_cast<Index>(count++) : number[first];
  });
  job.serial(order.size(), [&](std::size_t i) { welding.vertex[i] = number[welding.vertex[i]]; });
  if (count == 1 && place.size() > 1) refuse_distance();
  welding.vertices = count;
}

template <class T>
void permute(Array<T>& values, const Array<Index>& order, Job& job) {
  Array<T> permuted(values.size());
  job.serial(values.size(), [&](std::size_t i) { permuted[i] = values[order[i]]; });
  values.swap(permuted);
}

/// Replaces the values of the copies, in their order, by one for each vertex.
template <class T, class Merge>
void merge_copies(Array<T>& values, const RawMesh& mesh, Job& job, const Merge& merge) {
  if (values.empty()) return;
  const std::size_t vertices = mesh.copy_begin.size() - 1;
  Array<T> merged(vertices);
  job.serial(vertices, [&](std::size_t v) {
    merged[v] = values[mesh.copy_begin[v]];
    for (std::size_t k = mesh.copy_begin[v] + 1; k < mesh.copy_begin[v + 1]; ++k)
      merged[v] = merge(merged[v], values[k]);
  });
  values.swap(merged);
}

/// Puts the copies of each vertex side by side. In the order of space near ones need not be.
Array<Index> group_copies(const Array<Index>& order, const Welding& welding, Array<Index>& copy_begin, Job& job) {
  copy_begin.assign(welding.vertices + 1, 0);
  job.serial(order.size(), [&](std::size_t i) { ++copy_begin[welding.vertex[i] + 1]; });
  job.serial(welding.vertices, [&](std::size_t v) { copy_begin[v + 1] += copy_begin[v]; });
  Array<Index> next(copy_begin);
  Array<Index> grouped(order.size());
  job.serial(order.size(), [&](std::size_t i) { grouped[next[welding.vertex[i]]++] = order[i]; });
  return grouped;
}

}  // namespace

Welding weld(const Array<Vec3>& position, const Array<Index>& order, double distance, Job& job) {
  Welding welding = weld_equal(position, order, job);
  if (distance > 0) weld_near(position, order, distance, welding, job);
  return welding;
}

Array<Index> reorder_vertices(RawMesh& mesh, const Array<Index>& order, const Welding& welding, Job& job) {
  const bool joined = welding.vertices < order.size();
  Array<Index> by_vertex = joined ? group_copies(order, welding, mesh.copy_begin, job) : order;
  permute(mesh.position, by_vertex, job);
  permute(mesh.host_vertex, by_vertex, job);
  permute(mesh.selected, by_vertex, job);
  permute(mesh.weight, by_vertex, job);
  permute(mesh.counted_copies, by_vertex, job);
  if (!joined) return by_vertex;
  merge_copies(mesh.position, mesh, job, [](const Vec3& first, const Vec3& /*other*/) { return first; });
  merge_copies(mesh.selected, mesh, job, [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
  merge_copies(mesh.weight, mesh, job, [](double a, double b) { return std::min(a, b); });
  merge_copies(mesh.counted_copies, mesh, job, [](Index a, Index b) { return a + b; });
  return by_vertex;
}

}  // namespace vcg_core::detail
