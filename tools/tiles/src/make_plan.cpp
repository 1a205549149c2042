// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>

#include <tiles/tiles.h>

#include <durable_files/pending_file.h>
#include <vcg_core/errors.h>
#include <vcg_core/mesh/measures.h>

#include "bucket_file.h"
#include "bucket_writer.h"
#include "disk_space.h"
#include "fail.h"
#include "fingerprint.h"
#include "guided_plan.h"
#include "memory.h"
#include "piece.h"
#include "plan.h"
#include "scratch_folder.h"
#include "stage.h"

namespace tiles {
namespace {

constexpr std::size_t block = 3 << 14;  // vertices or faces that are read at once

void require_method(vcg_core::Method method) {
  if (can_be_cut(method)) return;
  throw vcg_core::InvalidParameter("method " + vcg_core::method_name(method) +
                                   " cannot be run in pieces; allowed are paper and guided");
}

/// @throws mesh_tools::FileError: a coordinate is not finite
Box box_of(const LargeMesh& mesh, Stage stage) {
  Box box;
  std::vector<Point> position(block);
  std::size_t at = 0, not_finite = 0, first = 0;
  VertexStream stream(mesh);
  while (const std::size_t count = stream.read(position)) {
    for (std::size_t i = 0; i < count; ++i) {
      const Point& p = position[i];
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
        if (not_finite++ == 0) first = at + i;
        continue;
      }
      box.extend(p);
    }
    at += count;
    stage.at(at, mesh.vertices());
  }
  if (not_finite > 0)
    fail(mesh.file().path(), std::to_string(not_finite) + (not_finite == 1 ? " vertex has" : " vertices have") +
                                 " a coordinate that is not a finite number, the first is vertex " +
                                 std::to_string(first));
  return box;
}

std::vector<std::uint32_t> vertices_in_cells(const LargeMesh& mesh, const Grid& grid, Stage stage) {
  std::vector<std::uint32_t> in_cell(grid.cells());
  std::vector<Point> position(block);
  std::size_t at = 0;
  VertexStream stream(mesh);
  while (const std::size_t count = stream.read(position)) {
    for (std::size_t i = 0; i < count; ++i) ++in_cell[grid.cell_of(position[i])];
    stage.at(at += count, mesh.vertices());
  }
  return in_cell;
}

/// Cells along the longest side of the box: surfaces fill about three times the square of that number.
std::uint32_t cells_along(std::size_t vertices, std::size_t tile_vertices, vcg_core::Method method) {
  const double in_cell = vertices_in_cell(tile_vertices, method);
  return static_cast<std::uint32_t>(std::clamp(std::sqrt(static_cast<double>(vertices) / in_cell / 3), 1.0, 256.0));
}

/// Sorts the vertices and the faces of a mesh into one file for each tile.
class Distribution {
 public:
  Distribution(const LargeMesh& mesh, const Plan& plan, const Cut& cut)
      : mesh_(mesh), plan_(plan), cut_(cut), tile_of_(mesh.vertices()) {}

  void spread_vertices(Stage stage) {
    BucketWriter writer(plan_.folder, "vertices_", cut_.tiles(), buffers);
    std::vector<Point> position(block);
    std::vector<char> record(sizeof(std::uint32_t) + 3 * plan_.real_size);
    std::size_t v = 0;
    VertexStream stream(mesh_);
    while (const std::size_t count = stream.read(position)) {
      for (std::size_t i = 0; i < count; ++i, ++v) {
        tile_of_[v] = static_cast<std::uint16_t>(cut_.tile_of(plan_.grid.cell_of(position[i])));
        put_vertex(static_cast<std::uint32_t>(v), position[i], record);
        writer.add(tile_of_[v], record.data(), record.size());
      }
      stage.at(v, mesh_.vertices());
    }
    writer.flush();
  }

  void spread_faces(Stage stage) {
    BucketWriter writer(plan_.folder, "faces_", cut_.tiles(), buffers);
    std::vector<Face> face(block);
    std::size_t f = 0;
    FaceStream stream(mesh_);
    while (const std::size_t count = stream.read(face)) {
      for (std::size_t i = 0; i < count; ++i, ++f) {
        const BucketFace record{face[i], static_cast<std::uint32_t>(f)};
        const std::uint16_t a = tile_of_[face[i][0]], b = tile_of_[face[i][1]], c = tile_of_[face[i][2]];
        writer.add(a, &record, sizeof record);
        if (b != a) writer.add(b, &record, sizeof record);
        if (c != a && c != b) writer.add(c, &record, sizeof record);
      }
      stage.at(f, mesh_.faces());
    }
    writer.flush();
    std::vector<std::uint16_t>().swap(tile_of_);
  }

  void sort_buckets(Stage stage) {
    const auto raw = [&](const char* kind, std::size_t tile) { return plan_.folder / (kind + std::to_string(tile)); };
    for (std::size_t tile = 0; tile < cut_.tiles(); ++tile) {
      BucketFile::make(plan_.bucket_path(tile), raw("vertices_", tile), raw("faces_", tile), plan_.real_size,
                       plan_.grid);
      stage.at(tile + 1, cut_.tiles());
    }
  }

 private:
  static constexpr std::size_t buffers = std::size_t(32) << 20;

  void put_vertex(std::uint32_t v, const Point& p, std::vector<char>& record) const {
    std::memcpy(record.data(), &v, sizeof v);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto narrow = static_cast<float>(p[k]);
      const void* const number = plan_.real_size == sizeof narrow ? static_cast<const void*>(&narrow) : &p[k];
      std::memcpy(record.data() + sizeof v + k * plan_.real_size, number, plan_.real_size);
    }
  }

  const LargeMesh& mesh_;
  const Plan& plan_;
  const Cut& cut_;
  std::vector<std::uint16_t> tile_of_;  ///< by vertex of the file
};

/// |e|, piece by piece: each counts the edges whose first vertex it has.
double measure_edges(const LargeMesh& mesh, const Plan& plan, Stage stage) {
  double sum = 0;
  std::size_t edges = 0;
  const PieceReader reader(plan, mesh);
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    Piece piece = reader.read(tile, -1);
    if (!piece.face.empty()) {
      const double part = 1 / static_cast<double>(plan.tiles());
      const vcg_core::MeshSummary summary = vcg_core::summarize(
          view_of(piece, plan), stage.part(part * static_cast<double>(tile), part * static_cast<double>(tile + 1)));
      sum += summary.average_edge_length * static_cast<double>(summary.edges);
      edges += summary.edges;
    }
    stage.at(tile + 1, plan.tiles());
  }
  if (!(sum > 0)) fail(mesh.file().path(), "the mesh has no edge of any length");
  return sum / static_cast<double>(edges);
}

/// How far, in |e|, the new position of a vertex depends on others.
double reach_in_edges(const Job& job) {
  if (job.method == vcg_core::Method::guided) return guided_reach(job.parameters);
  constexpr double margin = 1.5;  // half an edge that distances are followed beyond the cut-off, and one to be sure
  return job.parameters.iterations * (job.parameters.rho * job.parameters.sigma_c + margin);
}

/// Lays out the cut for a mesh whose vertices may crowd in few places.
void lay_cut(const LargeMesh& mesh, std::size_t tile_vertices, Plan& plan, std::vector<std::uint32_t>& in_cell,
             const vcg_core::Progress& progress) {
  std::uint32_t along = cells_along(mesh.vertices(), tile_vertices, plan.job.method);
  for (;;) {
    plan.grid = Grid(plan.box, along);
    in_cell = vertices_in_cells(mesh, plan.grid, Stage(progress, "Counting vertices", 0.05, 0.1));
    const std::uint32_t most = *std::max_element(in_cell.begin(), in_cell.end());
    if (most <= tile_vertices / 4 || plan.grid.cells() == 1 || along == 256) return;
    along = std::min<std::uint32_t>(256, 2 * along);
  }
}

}  // namespace

bool can_be_cut(vcg_core::Method method) {
  return method == vcg_core::Method::paper || method == vcg_core::Method::guided;
}

void make_plan(const std::filesystem::path& input, const std::filesystem::path& folder, std::size_t tile_vertices,
               const Job& job, const vcg_core::Progress& progress,
               const std::function<void(const std::string&)>& tell) {
  require_method(job.method);
  if (job.parameters.check) throw vcg_core::InvalidParameter("check cannot be done in pieces");
  if (job.parameters.selected_only) throw vcg_core::InvalidParameter("selected cannot be used in pieces");
  if (job.parameters.smooth_color) throw vcg_core::InvalidParameter("smooth_color cannot be done in pieces");
  const LargeMesh mesh(input);
  if (!job.passes_over_selection && mesh.has_selection())
    fail(input, "has a selection, which pieces cannot follow; --no-selected moves all vertices");
  Plan plan;
  plan.job = job;
  plan.input = std::filesystem::absolute(input);
  plan.input_size = mesh.file().size();
  plan.input_modified = mesh.file().modified();
  plan.input_samples = sample_checksum(mesh.file(), mesh.header_size());
  plan.vertices = mesh.vertices();
  plan.faces = mesh.faces();
  plan.real_size = mesh.real_size();
  plan.normal_size = mesh.normal_size();

  ScratchFolder scratch(folder);
  const std::uint64_t needed = disk_bytes(plan.vertices, plan.faces, plan.real_size, plan.normal_size);
  if (tell)
    tell("needs " + in_bytes(needed) + " of disk space in " + folder.string() + " until the pieces are put together");
  require_space(folder, scratch.path(), needed);

  plan.box = box_of(mesh, Stage(progress, "Measuring", 0, 0.05));
  std::vector<std::uint32_t> in_cell;
  lay_cut(mesh, tile_vertices, plan, in_cell, progress);
  const Cut cut(plan.grid, in_cell, (plan.vertices + tile_vertices - 1) / tile_vertices);
  plan.cut = cut.nodes();
  plan.vertices_of.resize(cut.tiles());
  for (std::uint32_t cell = 0; cell < in_cell.size(); ++cell) plan.vertices_of[cut.tile_of(cell)] += in_cell[cell];
  std::vector<std::uint32_t>().swap(in_cell);

  plan.folder = scratch.path();
  {
    Distribution distribution(mesh, plan, cut);
    distribution.spread_vertices(Stage(progress, "Sorting vertices", 0.1, 0.2));
    distribution.spread_faces(Stage(progress, "Sorting faces", 0.2, 0.45));
    distribution.sort_buckets(Stage(progress, "Ordering pieces", 0.45, 0.6));
  }
  const bool is_guided = job.method == vcg_core::Method::guided;
  plan.average_edge_length = measure_edges(mesh, plan, Stage(progress, "Measuring edges", 0.6, is_guided ? 0.7 : 1));
  if (is_guided)
    plan.guided = measure_guided(mesh, plan, std::max(tile_vertices, usual_sample),
                                 Stage(progress, "Measuring the noise", 0.7, 1));
  plan.reach = reach_in_edges(job) * plan.average_edge_length;
  durable_files::PendingFile file(plan.folder / "plan.json");
  file.write(plan_text(plan));
  file.complete();
  file.put_in_place();
  scratch.put_in_place();
}

PlanSummary plan_summary(const std::filesystem::path& folder) {
  const Plan plan = read_plan(folder);
  PlanSummary summary;
  summary.tiles = plan.tiles();
  summary.vertices = plan.vertices;
  summary.faces = plan.faces;
  summary.average_edge_length = plan.average_edge_length;
  summary.halo = plan.reach;
  summary.largest_tile = *std::max_element(plan.vertices_of.begin(), plan.vertices_of.end());
  summary.disk_bytes = disk_bytes(plan.vertices, plan.faces, plan.real_size, plan.normal_size);
  summary.memory_bytes = memory_of_piece(summary.largest_tile, plan.vertices, plan.faces, plan.job.method);
  return summary;
}

}  // namespace tiles
