// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <tiles/tiles.h>

#include "plan.h"
#include "scratch_folder.h"
#include "stage.h"

namespace tiles {

Finished smooth_in_pieces(const std::filesystem::path& input, const std::filesystem::path& output, std::uint64_t memory,
                          const Job& job, const vcg_core::Progress& progress,
                          const std::function<void(const std::string&)>& tell, const ReportFile& with) {
  require_same_format(input, output);
  const std::size_t tile_vertices = tile_vertices_within(memory, input, job.method);
  const std::filesystem::path beside = std::filesystem::absolute(output);
  const ScratchFolder scratch(beside.parent_path() / (beside.filename().string() + ".plan"));
  const std::filesystem::path plan = scratch.path() / "plan";
  const Stage planning(progress, "Planning", 0, 0.25);
  make_plan(input, plan, tile_vertices, job, planning.part(0, 1), tell);
  const std::size_t tiles = plan_summary(plan).tiles;
  const Stage running(progress, "Smoothing", 0.25, 0.95);
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    const double part = 1 / static_cast<double>(tiles);
    run_tile(plan, tile, job.parameters.threads,
             running.part(part * static_cast<double>(tile), part * static_cast<double>(tile + 1)));
  }
  const Stage finishing(progress, "Writing", 0.95, 1);
  return finish(plan, output, finishing.part(0, 1), with);
}

}  // namespace tiles
