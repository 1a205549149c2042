// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vcg_core/method.h>
#include <vcg_core/progress.h>
#include <vcg_core/smoothing_limits.h>
#include <vcg_core/smoothing_parameters.h>
#include <vcg_core/smoothing_report.h>

/// Smoothing of meshes that are larger than memory, in pieces. A folder, the plan, holds all that a piece needs,
/// ordered by place; pieces are then smoothed one by one, by any number of processes that see the folder; at last the
/// file is written again with the new positions. The result is that of smoothing the whole, up to rounding: see
/// docs/large-meshes.md. It depends on the file and the options only.
///
/// All functions throw mesh_tools::FileError and durable_files::WriteError with one sentence, and vcg_core::Cancelled.
namespace tiles {

/// What is done to the mesh.
struct Job {
  vcg_core::Method method = vcg_core::Method::paper;
  vcg_core::SmoothingParameters parameters;  ///< of them `threads` may differ from run to run
  vcg_core::SmoothingLimits limits;
  bool passes_over_selection = false;  ///< whether all vertices move although the file has a selection
};

/// What a plan will cost.
struct PlanSummary {
  std::size_t tiles = 0;
  std::size_t vertices = 0, faces = 0;
  double average_edge_length = 0;
  double halo = 0;                 ///< how far around a tile its piece reaches at least, in the mesh's unit
  std::size_t largest_tile = 0;    ///< vertices
  std::uint64_t disk_bytes = 0;    ///< of the plan's folder, when all pieces are done
  std::uint64_t memory_bytes = 0;  ///< of a process that smooths the largest piece, about
};

/// Methods whose neighbourhoods are bounded, so that a mesh can be cut for them.
bool can_be_cut(vcg_core::Method method);

/// The number of vertices of a tile, so that neither the plan nor a piece needs more memory than this.
/// @param vertices  of the whole mesh
/// @throws mesh_tools::FileError  naming the least memory that is enough
std::size_t tile_vertices_within(std::uint64_t memory, const std::filesystem::path& input, vcg_core::Method method);

/// About how much memory it takes to smooth the whole file at once.
std::uint64_t memory_of_whole(const std::filesystem::path& input, vcg_core::Method method);

/// Makes a plan: reads the file four times from beginning to end. The folder appears whole or not at all.
/// @param folder  is not there, or empty
/// @param tell    gets a sentence about the disk space before work begins
void make_plan(const std::filesystem::path& input, const std::filesystem::path& folder, std::size_t tile_vertices,
               const Job& job, const vcg_core::Progress& progress,
               const std::function<void(const std::string&)>& tell = {});

PlanSummary plan_summary(const std::filesystem::path& folder);

/// How a tile came to be done.
struct TileOutcome {
  bool was_done = false;  ///< before, so that nothing was to do
  std::string warning;    ///< a sentence if there was a result that cannot be used
};

/// Smooths a piece, and leaves its result in the plan's folder. Any number of processes may do so at once, the same
/// piece too.
/// @throws mesh_tools::FileError: the file is not what it was when the plan was made; there is no such tile
TileOutcome run_tile(const std::filesystem::path& folder, std::size_t tile, int threads,
                     const vcg_core::Progress& progress);

/// What has been done, over all pieces.
struct Finished {
  vcg_core::SmoothingReport report;
  Job job;
};

/// A text file that appears together with the mesh.
struct ReportText {
  std::filesystem::path path;
  std::string text;
};
using ReportFile = std::function<ReportText(const Finished&)>;

/// Writes the input again with the new positions, and the normals that follow, as one complete file. Does not change
/// the plan.
/// @throws mesh_tools::FileError: pieces are missing, cut off or of another plan
/// @param with  gives a file that appears together with the mesh, or neither of them; may be empty
Finished finish(const std::filesystem::path& folder, const std::filesystem::path& output,
                const vcg_core::Progress& progress, const ReportFile& with = {});

/// The three steps, with the plan in a hidden folder beside the output that is removed at the end.
Finished smooth_in_pieces(const std::filesystem::path& input, const std::filesystem::path& output, std::uint64_t memory,
                          const Job& job, const vcg_core::Progress& progress,
                          const std::function<void(const std::string&)>& tell = {}, const ReportFile& with = {});

}  // namespace tiles
