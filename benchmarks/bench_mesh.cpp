// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_mesh.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <job.h>
#include <mesh/read_mesh.h>
#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>
#include <vcg_core/mesh/vcglib_view.h>

#include "filters/paper/lanes/lane_kernels.h"
#include "filters/paper/lanes/lane_parameters.h"
#include "filters/paper/lanes/patch_builder.h"
#include "filters/paper/lanes/source_groups.h"
#include "vertex_normals.h"

namespace bench {

using namespace vcg_core::detail;

namespace {

const vcg_core::Progress silent;

mesh_tools::Mesh make_noisy_mesh(const Kind& kind) {
  mesh_tools::Mesh mesh = mesh_tools::make_shape(kind.shape, kind.vertices);
  mesh_tools::add_noise(mesh, kind.noise, 1, mesh_tools::NoiseDirection::normal);
  if (kind.order == Order::as_made) return mesh;
  std::vector<std::size_t> to(mesh.vert.size());
  std::iota(to.begin(), to.end(), std::size_t(0));
  std::shuffle(to.begin(), to.end(), std::mt19937(1));
  mesh_tools::Mesh shuffled;
  vcg::tri::Allocator<mesh_tools::Mesh>::AddVertices(shuffled, mesh.vert.size());
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) shuffled.vert[to[v]].P() = mesh.vert[v].P();
  std::vector<std::size_t> faces(mesh.face.size());
  std::iota(faces.begin(), faces.end(), std::size_t(0));
  std::shuffle(faces.begin(), faces.end(), std::mt19937(2));
  vcg::tri::Allocator<mesh_tools::Mesh>::AddFaces(shuffled, mesh.face.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k)
      shuffled.face[f].V(k) = &shuffled.vert[to[vcg::tri::Index(mesh, mesh.face[faces[f]].V(k))]];
  return shuffled;
}

}  // namespace

bool Kind::operator<(const Kind& other) const {
  return std::tie(vertices, order, shape, noise) < std::tie(other.vertices, other.order, other.shape, other.noise);
}

const mesh_tools::Mesh& noisy_mesh(const Kind& kind) {
  static std::map<Kind, mesh_tools::Mesh> kept;
  const auto found = kept.find(kind);
  return found != kept.end() ? found->second : kept.emplace(kind, make_noisy_mesh(kind)).first->second;
}

Job single_thread() { return Job(silent, 1); }

const Arrays& noisy_arrays(const Kind& kind) {
  static std::map<Kind, Arrays> kept;
  const auto found = kept.find(kind);
  if (found != kept.end()) return found->second;
  Job job = single_thread();
  Arrays arrays{read_mesh(vcg_core::view_of(noisy_mesh(kind)), job), {}, {}};
  arrays.normal = vertex_normals(arrays.mesh, arrays.mesh.position, job);
  arrays.movable.assign(arrays.mesh.size(), 1);
  return kept.emplace(kind, std::move(arrays)).first->second;
}

std::size_t count_pairs(const Arrays& arrays, double rho) {
  Job job = single_thread();
  const LaneKernel& kernel = *supported_lane_kernels().front();
  const Rings ring = make_rings(arrays.mesh, job);
  const SourceGroups groups = group_sources(arrays.mesh, kernel.lanes, job);
  const LaneMesh lanes{arrays.mesh, ring, groups, arrays.mesh.position, arrays.normal};
  PatchBuilder builder(lanes, kernel);
  vcg_core::PaperParameters wanted;
  wanted.sigma_c = rho / wanted.rho;
  const LaneParameters parameters = lane_parameters(wanted);
  const LanePoll no_poll = [](void*) {};
  std::size_t pairs = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (std::none_of(groups.member.begin() + groups.begin[g], groups.member.begin() + groups.begin[g + 1],
                     [&](Index v) { return arrays.movable[v] != 0; }))
      continue;
    const Patch& patch = builder.build(g, g + 1, rho + 0.5);
    const PatchGroup& group = builder.group(g);
    kernel.shape(patch, no_poll, nullptr);
    kernel.march(patch, group, parameters, no_poll, nullptr);
    for (std::uint32_t rank = 0; rank < group.rows; ++rank)
      for (std::uint32_t lane = 0; lane < group.sources; ++lane)
        pairs += arrays.movable[groups.member[groups.begin[g] + lane]] != 0 &&
                 patch.distance[std::size_t(group.row_at[rank]) * kernel.lanes + lane] < parameters.cutoff;
  }
  return pairs;
}

}  // namespace bench
