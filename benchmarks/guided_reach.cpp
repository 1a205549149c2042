// SPDX-License-Identifier: GPL-3.0-or-later
// guided_reach IN... : how far the guided filter's result depends on what is around. Cuts each mesh in two, smooths one
// half with what lies within so many edge lengths of the cut, and prints how far its vertices come out from where they
// do in the whole, in |e|. For docs/large-meshes.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <vector>

#include <mesh_tools/mesh_io.h>
#include <vcg_core/mesh/guided_measures.h>
#include <vcg_core/mesh/measures.h>
#include <vcg_core/mesh/smoothing.h>

namespace {

using Point = std::array<double, 3>;

struct Mesh {
  std::vector<Point> point;
  std::vector<std::array<std::uint32_t, 3>> face;

  vcg_core::MeshView view() {
    return vcg_core::packed_mesh(point.data()->data(), point.size(), face.data()->data(), face.size());
  }
};

Mesh read(const char* path) {
  const mesh_tools::MeshFile file = mesh_tools::read_mesh(path);
  Mesh mesh;
  for (const auto& v : file.mesh.vert) mesh.point.push_back({v.cP()[0], v.cP()[1], v.cP()[2]});
  for (const auto& f : file.mesh.face) {
    std::array<std::uint32_t, 3> face{};
    for (int k = 0; k < 3; ++k)
      face[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(f.cV(k) - file.mesh.vert.data());
    mesh.face.push_back(face);
  }
  return mesh;
}

vcg_core::WholeMesh measure(Mesh& mesh, const vcg_core::SmoothingParameters& parameters) {
  vcg_core::WholeMesh whole;
  whole.average_edge_length = vcg_core::summarize(mesh.view()).average_edge_length;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto less = [k](const Point& a, const Point& b) { return a[k] < b[k]; };
    const auto [least, largest] = std::minmax_element(mesh.point.begin(), mesh.point.end(), less);
    whole.box_min[k] = (*least)[k];
    whole.box_max[k] = (*largest)[k];
  }
  whole.guided.emplace();
  vcg_core::MeshView view = mesh.view();
  view.whole = whole;
  const vcg_core::NoiseOfPiece noise = vcg_core::noise_of_piece(view);
  whole.guided->testimony = noise.testimony;
  vcg_core::MeanNoise mean(*whole.guided, whole.average_edge_length);
  mean.add(noise.vertices);
  whole.guided->noise = mean.value();
  view.whole = whole;
  whole.guided->medians = vcg_core::guided_medians(view, parameters);
  return whole;
}

/// The vertices beyond a plane along x, what lies within `reach` of it, and all faces of these.
struct Part {
  Mesh mesh;
  std::vector<std::size_t> index;  ///< in the whole
  std::vector<bool> is_own;
};

Part cut(const Mesh& mesh, double plane, double reach) {
  constexpr auto outside = static_cast<std::uint32_t>(-1);
  const auto is_seen = [&](std::uint32_t v) { return mesh.point[v][0] >= plane - reach; };
  Part part;
  std::vector<std::uint32_t> place(mesh.point.size(), outside);
  for (std::array<std::uint32_t, 3> face : mesh.face) {
    if (!std::any_of(face.begin(), face.end(), is_seen)) continue;
    for (std::uint32_t& v : face) {
      if (place[v] == outside) {
        place[v] = static_cast<std::uint32_t>(part.index.size());
        part.index.push_back(v);
        part.mesh.point.push_back(mesh.point[v]);
        part.is_own.push_back(mesh.point[v][0] >= plane);
      }
      v = place[v];
    }
    part.mesh.face.push_back(face);
  }
  return part;
}

double distance(const Point& p, const Point& q) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
  return std::sqrt(sum);
}

void run(const char* path, const vcg_core::SmoothingParameters& parameters) {
  Mesh mesh = read(path);
  const vcg_core::WholeMesh whole = measure(mesh, parameters);
  Mesh expected = mesh;
  smooth(expected.view(), vcg_core::Method::guided, parameters);
  const double e = whole.average_edge_length, plane = (whole.box_min[0] + whole.box_max[0]) / 2;
  for (const double reach : {8., 16., 24., 32., 40., 48.}) {
    Part part = cut(mesh, plane, reach * e);
    vcg_core::MeshView view = part.mesh.view();
    view.whole = whole;
    smooth(view, vcg_core::Method::guided, parameters);
    std::vector<double> off;
    for (std::size_t v = 0; v < part.index.size(); ++v)
      if (part.is_own[v]) off.push_back(distance(part.mesh.point[v], expected.point[part.index[v]]) / e);
    std::sort(off.begin(), off.end());
    std::printf("%s, %s: %g |e|: largest %.1e, 99.99 %% below %.1e\n", path,
                parameters.blend == vcg_core::Blend::on ? "blend" : "no blend", reach, off.back(),
                off[off.size() - 1 - off.size() / 10000]);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    vcg_core::SmoothingParameters parameters = vcg_core::method_info(vcg_core::Method::guided).defaults;
    for (const vcg_core::Blend blend : {vcg_core::Blend::on, vcg_core::Blend::off}) {
      parameters.blend = blend;
      for (int k = 1; k < argc; ++k) run(argv[k], parameters);
    }
  } catch (const std::exception& error) {
    std::cerr << "guided_reach: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
