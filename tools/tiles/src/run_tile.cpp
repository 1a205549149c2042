// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <tiles/tiles.h>

#include <vcg_core/mesh/smoothing.h>

#include "fail.h"
#include "piece.h"
#include "piece_normals.h"
#include "piece_result.h"
#include "stage.h"

namespace tiles {
namespace {

/// Of vertices that no face touches.
vcg_core::SmoothingReport report_of_points(const Plan& plan, const Piece& piece) {
  vcg_core::SmoothingReport report;
  report.average_edge_length = plan.average_edge_length;
  report.vertices = report.skipped_vertices.isolated = piece.own_index.size();
  report.closed = true;
  if (plan.guided) report.estimated_noise = plan.guided->noise;
  return report;
}

void append(const Point& p, std::size_t size, std::vector<char>& bytes) {
  for (const double& wide : p) {
    const auto narrow = static_cast<float>(wide);
    const char* const raw =
        size == sizeof narrow ? reinterpret_cast<const char*>(&narrow) : reinterpret_cast<const char*>(&wide);
    bytes.insert(bytes.end(), raw, raw + size);
  }
}

/// @param normal  of the tile's vertices; none if the file has none
std::vector<char> own_rows(const Plan& plan, const Piece& piece, const std::vector<Point>& normal) {
  std::vector<char> rows;
  rows.reserve(piece.own_index.size() * plan.result_row());
  std::size_t own = 0;
  for (std::size_t v = 0; v < piece.vertices(); ++v) {
    if (!piece.own_vertex[v]) continue;
    append(piece.position(v), plan.real_size, rows);
    if (plan.normal_size > 0) append(normal[own], plan.normal_size, rows);
    ++own;
  }
  return rows;
}

std::string sentence(const Plan& plan, std::size_t tile, ResultState state) {
  if (state == ResultState::cut_off) return plan.result_path(tile).string() + ": is cut off; it is made again";
  if (state == ResultState::of_another_plan)
    return plan.result_path(tile).string() + ": belongs to another plan; it is made again";
  return {};
}

}  // namespace

TileOutcome run_tile(const std::filesystem::path& folder, std::size_t tile, int threads,
                     const vcg_core::Progress& progress) {
  const Plan plan = read_plan(folder);
  if (tile >= plan.tiles())
    fail(folder, "has no piece " + std::to_string(tile) + "; allowed are 0 to " + std::to_string(plan.tiles() - 1));
  const LargeMesh mesh = open_input(plan);
  TileOutcome outcome;
  const ResultState state = state_of_result(plan, tile);
  outcome.was_done = state == ResultState::whole;
  if (outcome.was_done) return outcome;
  outcome.warning = sentence(plan, tile, state);

  Stage stage(progress, "Smoothing", 0, 1);
  Piece piece = PieceReader(plan, mesh).read(tile, plan.reach);
  const std::vector<double> before = plan.normal_size > 0 ? piece.positions() : std::vector<double>();
  PieceResult result;
  if (piece.face.empty()) {
    result.report = report_of_points(plan, piece);
  } else {
    const bool is_one_step = plan.job.method == vcg_core::Method::paper && plan.job.parameters.iterations == 1;
    if (is_one_step) hold_surroundings(piece);
    vcg_core::SmoothingParameters parameters = plan.job.parameters;
    parameters.threads = threads;
    result.report =
        vcg_core::smooth(view_of(piece, plan), plan.job.method, parameters, stage.part(0.05, 0.98), plan.job.limits);
  }
  std::vector<Point> normal;
  if (plan.normal_size > 0) normal = moved_normals(mesh, before, piece);
  result.rows = own_rows(plan, piece, normal);
  write_result(plan, tile, result);
  return outcome;
}

}  // namespace tiles
