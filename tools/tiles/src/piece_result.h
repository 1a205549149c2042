// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <vcg_core/smoothing_report.h>

#include "input_file.h"
#include "plan.h"

namespace tiles {

/// What became of the vertices of a tile, in the order of the file, and the figures of the tile.
struct PieceResult {
  vcg_core::SmoothingReport report;
  std::vector<char> rows;  ///< of Plan::result_row() bytes: the position, and the normal if the file has any
};

struct NewVertex {
  Point position, normal;
};

/// Writes it whole or not at all, in the place of another one too.
/// @throws durable_files::WriteError
void write_result(const Plan& plan, std::size_t tile, const PieceResult& result);

enum class ResultState { missing, cut_off, of_another_plan, whole };

/// Looks through a result.
/// @throws mesh_tools::FileError: it cannot be read
ResultState state_of_result(const Plan& plan, std::size_t tile);

/// Reads a result that is whole, its vertices in small parts.
class ResultReader {
 public:
  ResultReader(const Plan& plan, std::size_t tile, std::size_t buffer);
  const vcg_core::SmoothingReport& report() const { return report_; }
  /// The next vertex of the tile.
  NewVertex next();

 private:
  std::filesystem::path path_;
  std::size_t real_size_, normal_size_, buffer_size_;
  std::uint64_t at_ = 0, end_ = 0;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
  vcg_core::SmoothingReport report_;
};

}  // namespace tiles
