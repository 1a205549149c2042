// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tiles/tiles.h>
#include <vcg_core/mesh/guided_whole.h>

#include "cut.h"
#include "grid.h"
#include "large_mesh.h"

namespace tiles {

/// What plan.json holds.
struct Plan {
  std::filesystem::path folder;
  std::uint64_t id = 0;  ///< checksum of all that follows

  std::filesystem::path input;
  std::uint64_t input_size = 0;
  std::int64_t input_modified = 0;
  std::uint64_t input_samples = 0;  ///< sample_checksum()

  Job job;
  std::size_t vertices = 0, faces = 0, real_size = 4, normal_size = 0;
  Box box;
  double average_edge_length = 0;
  double reach = 0;  ///< how far a vertex's new position depends on others, in the mesh's unit
  std::optional<vcg_core::GuidedWhole> guided;  ///< of the guided method only
  Grid grid;
  std::vector<Cut::Node> cut;
  std::vector<std::size_t> vertices_of;  ///< by tile

  /// Bytes of a vertex in a result: its place, and its normal if the file has any.
  std::size_t result_row() const { return 3 * (real_size + normal_size); }
  std::size_t tiles() const { return vertices_of.size(); }
  std::filesystem::path bucket_path(std::size_t tile) const;
  std::filesystem::path result_path(std::size_t tile) const;
};

/// The text of plan.json.
std::string plan_text(Plan& plan);

/// @throws mesh_tools::FileError
Plan read_plan(const std::filesystem::path& folder);

/// Throws mesh_tools::FileError unless pieces of one can be written as the other.
void require_same_format(const std::filesystem::path& input, const std::filesystem::path& output);

/// Opens the file that the plan is of.
/// @throws mesh_tools::FileError: it has changed since
LargeMesh open_input(const Plan& plan);

}  // namespace tiles
