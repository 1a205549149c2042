// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <tiles/tiles.h>

#include <durable_files/pending_file.h>
#include <vcg_core/errors.h>

#include "disk_space.h"
#include "fail.h"
#include "io/file_names.h"
#include "io/ply_layout.h"
#include "piece_result.h"
#include "plan.h"
#include "report_sum.h"
#include "stage.h"

namespace tiles {
namespace {

/// The new positions of all vertices in the order of the file, from the results of the tiles.
class NewPositions {
 public:
  explicit NewPositions(const Plan& plan) : plan_(plan), cut_(plan.grid, plan.cut) {
    constexpr std::size_t buffers = std::size_t(64) << 20;
    const std::size_t buffer = std::clamp<std::size_t>(buffers / plan.tiles(), 1 << 10, 1 << 20);
    for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
      result_.emplace_back(plan, tile, buffer);
      add_report(result_.back().report(), report);
    }
  }

  /// To be called for all vertices in their order.
  NewVertex next(const Point& before) { return result_[cut_.tile_of(plan_.grid.cell_of(before))].next(); }

  vcg_core::SmoothingReport report;

 private:
  const Plan& plan_;
  Cut cut_;
  std::vector<ResultReader> result_;
};

void require_all_results(const Plan& plan, Stage stage) {
  std::size_t missing = 0, first = 0;
  for (std::size_t tile = 0; tile < plan.tiles(); ++tile) {
    switch (state_of_result(plan, tile)) {
      case ResultState::missing:
        if (missing++ == 0) first = tile;
        break;
      case ResultState::cut_off:
        fail(plan.result_path(tile), "is cut off; 'anisosmooth tiles run' makes it again");
      case ResultState::of_another_plan:
        fail(plan.result_path(tile), "belongs to another plan; 'anisosmooth tiles run' makes it again");
      case ResultState::whole:
        break;
    }
    stage.at(tile + 1, plan.tiles());
  }
  if (missing > 0)
    fail(plan.folder, std::to_string(missing) + " of " + std::to_string(plan.tiles()) +
                          " pieces are missing, the first is " + std::to_string(first) +
                          "; 'anisosmooth tiles run' makes them");
}

/// The rows of vertices, or of facets, with the new positions.
class RowWriter {
 public:
  RowWriter(const LargeMesh& mesh, NewPositions& positions)
      : rows_(mesh.vertex_rows()),
        normals_(mesh.normal_size() > 0 ? &mesh.normal_rows() : nullptr),
        positions_(positions) {}

  void put_vertex(char* row) const {
    const NewVertex now = positions_.next(position_in(row));
    for (std::size_t k = 0; k < 3; ++k) {
      rows_.put(row, k, now.position[k]);
      if (normals_ != nullptr) normals_->put(row, k, now.normal[k]);
    }
  }

  void put_facet(char* row) const {
    constexpr std::size_t corner_size = 3 * sizeof(float);
    Point corner[3];
    bool moved = false;
    for (std::size_t c = 0; c < 3; ++c) {
      char* const at = row + c * corner_size;
      const Point before = position_in(at);
      corner[c] = positions_.next(before).position;
      moved |= corner[c] != before;
      for (std::size_t k = 0; k < 3; ++k) rows_.put(at, k, corner[c][k]);
    }
    if (moved) put_facet_normal(row, corner);
  }

 private:
  Point position_in(const char* row) const {
    return {rows_.coordinate(row, 0), rows_.coordinate(row, 1), rows_.coordinate(row, 2)};
  }

  /// A facet without a direction keeps its normal.
  void put_facet_normal(char* row, const Point (&corner)[3]) const {
    Point a, b;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = corner[1][k] - corner[0][k];
      b[k] = corner[2][k] - corner[0][k];
    }
    const Point normal = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(length > 0)) return;
    RowPlace place = rows_;
    for (std::size_t k = 0; k < 3; ++k) {
      place.offset[k] = k * sizeof(float);
      place.put(row, k, static_cast<double>(static_cast<float>(normal[k] / length)));
    }
  }

  const RowPlace& rows_;
  const RowPlace* normals_;
  NewPositions& positions_;
};

void copy_bytes(const InputFile& from, std::uint64_t begin, std::uint64_t end, durable_files::PendingFile& to,
                Stage& stage) {
  SequentialReader reader(from, begin, end);
  const char* bytes = nullptr;
  while (const std::size_t count = reader.take_some(bytes, SequentialReader::usual_buffer)) {
    to.write({bytes, count});
    stage.at(static_cast<std::size_t>(reader.at()), static_cast<std::size_t>(from.size()));
  }
}

/// The header, in which the names of textures mean the same files where `output` lies.
std::string moved_header(const LargeMesh& mesh, const std::filesystem::path& output) {
  std::string header(static_cast<std::size_t>(mesh.header_size()), '\0');
  mesh.file().read(0, header.data(), header.size());
  if (mesh.is_stl()) return header;
  const std::string original = header;
  const mesh_tools::io::PlyLayout layout = mesh_tools::io::parse_ply_header(original, mesh.file().path());
  const std::vector<std::string_view> names = mesh_tools::io::texture_names(layout);
  const std::filesystem::path from = mesh.file().path().parent_path();
  const std::filesystem::path to = std::filesystem::absolute(output).parent_path();
  for (auto name = names.rbegin(); name != names.rend(); ++name)
    header.replace(static_cast<std::size_t>(name->data() - original.data()), name->size(),
                   mesh_tools::io::moved_file_name(*name, from, to));
  return header;
}

void write_moved(const LargeMesh& mesh, const std::filesystem::path& output, NewPositions& positions,
                 durable_files::PendingFile& to, Stage& stage) {
  const RowPlace& rows = mesh.vertex_rows();
  to.write(moved_header(mesh, output));
  copy_bytes(mesh.file(), mesh.header_size(), rows.begin, to, stage);
  const std::size_t count = mesh.is_stl() ? mesh.faces() : mesh.vertices();
  const std::size_t at_once = std::max<std::size_t>(1, SequentialReader::usual_buffer / rows.stride);
  const RowWriter writer(mesh, positions);
  SequentialReader reader(mesh.file(), rows.begin, rows.begin + count * rows.stride);
  std::vector<char> part;
  for (std::size_t done = 0; done < count;) {
    const std::size_t rows_here = std::min(at_once, count - done);
    const char* const bytes = reader.take(rows_here * rows.stride);
    part.assign(bytes, bytes + rows_here * rows.stride);
    for (std::size_t i = 0; i < rows_here; ++i) {
      char* const row = part.data() + i * rows.stride;
      mesh.is_stl() ? writer.put_facet(row) : writer.put_vertex(row);
    }
    to.write({part.data(), part.size()});
    done += rows_here;
    stage.at(static_cast<std::size_t>(reader.at()), static_cast<std::size_t>(mesh.file().size()));
  }
  copy_bytes(mesh.file(), rows.begin + count * rows.stride, mesh.file().size(), to, stage);
}

}  // namespace

void require_same_format(const std::filesystem::path& input, const std::filesystem::path& output) {
  if (output.extension() != input.extension())
    fail(output, "cannot be written: its pieces are those of a " + input.extension().string() + " file");
}

Finished finish(const std::filesystem::path& folder, const std::filesystem::path& output,
                const vcg_core::Progress& progress, const ReportFile& with) {
  const Plan plan = read_plan(folder);
  const LargeMesh mesh = open_input(plan);
  require_same_format(plan.input, output);
  require_all_results(plan, Stage(progress, "Looking at the pieces", 0, 0.1));
  require_space(output, output.parent_path(), mesh.file().size());
  NewPositions positions(plan);
  Finished finished{positions.report, plan.job};
  Stage stage(progress, "Writing", 0.1, 1);
  durable_files::PendingFile file(output);
  write_moved(mesh, output, positions, file, stage);
  file.complete();
  std::optional<durable_files::PendingFile> report;
  if (with) {
    const ReportText text = with(finished);
    report.emplace(text.path);
    report->write(text.text);
    report->complete();
  }
  if (progress && !progress(1, "Writing")) throw vcg_core::Cancelled();
  file.put_in_place();
  if (report) report->put_in_place();
  return finished;
}

}  // namespace tiles
