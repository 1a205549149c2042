// SPDX-License-Identifier: GPL-3.0-or-later
#include "piece_result.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include <durable_files/pending_file.h>
#include <nlohmann/json.hpp>

#include "fail.h"
#include "fingerprint.h"
#include "report_sum.h"

namespace tiles {
namespace {

constexpr std::uint64_t magic = 0x316c7573657274;  // changes with the layout

struct Header {
  std::uint64_t magic_number, plan, tile, report_bytes, position_bytes;
  std::uint64_t checksum;  ///< of all that follows
};

std::string_view bytes_of(const Header& header) { return {reinterpret_cast<const char*>(&header), sizeof header}; }

/// Filled up, so that the checksum of the whole is that of its parts.
std::string report_text(const vcg_core::SmoothingReport& report) {
  std::string text = report_to_json(report).dump();
  text.resize((text.size() + 7) / 8 * 8, ' ');
  return text;
}

double number_at(const char* raw, std::size_t size) {
  double wide = 0;
  float narrow = 0;
  if (size == sizeof wide) {
    std::memcpy(&wide, raw, sizeof wide);
    return wide;
  }
  std::memcpy(&narrow, raw, sizeof narrow);
  return static_cast<double>(narrow);
}

Header read_header(const InputFile& file) {
  Header header{};
  file.read(0, &header, sizeof header);
  return header;
}

}  // namespace

void write_result(const Plan& plan, std::size_t tile, const PieceResult& result) {
  const std::string report = report_text(result.report);
  Checksum sum;
  sum.add(report);
  sum.add(result.rows.data(), result.rows.size());
  durable_files::PendingFile file(plan.result_path(tile));
  file.write(bytes_of({magic, plan.id, tile, report.size(), result.rows.size(), sum.value()}));
  file.write(report);
  file.write({result.rows.data(), result.rows.size()});
  file.complete();
  file.put_in_place();
}

ResultState state_of_result(const Plan& plan, std::size_t tile) {
  const std::filesystem::path path = plan.result_path(tile);
  if (!std::filesystem::exists(path)) return ResultState::missing;
  const InputFile file(path);
  if (file.size() < sizeof(Header)) return ResultState::cut_off;
  const Header header = read_header(file);
  if (header.magic_number != magic || header.plan != plan.id || header.tile != tile ||
      header.position_bytes != plan.vertices_of[tile] * plan.result_row())
    return ResultState::of_another_plan;
  if (file.size() != sizeof header + header.report_bytes + header.position_bytes) return ResultState::cut_off;
  Checksum sum;
  SequentialReader reader(file, sizeof header, file.size());
  const char* bytes = nullptr;
  while (reader.left() > 0) {
    const std::size_t part = reader.take_some(bytes, SequentialReader::usual_buffer);
    sum.add(bytes, part);
  }
  return sum.value() == header.checksum ? ResultState::whole : ResultState::cut_off;
}

ResultReader::ResultReader(const Plan& plan, std::size_t tile, std::size_t buffer)
    : path_(plan.result_path(tile)),
      real_size_(plan.real_size),
      normal_size_(plan.normal_size),
      buffer_size_(std::max<std::size_t>(1, buffer / plan.result_row()) * plan.result_row()) {
  const InputFile file(path_);
  const Header header = read_header(file);
  std::string text(static_cast<std::size_t>(header.report_bytes), ' ');
  file.read(sizeof header, text.data(), text.size());
  report_ = report_from_json(nlohmann::ordered_json::parse(text));
  at_ = sizeof header + header.report_bytes;
  end_ = at_ + header.position_bytes;
}

NewVertex ResultReader::next() {
  if (used_ == buffer_.size()) {
    if (at_ == end_) fail(path_, "holds fewer vertices than its tile has");
    buffer_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(buffer_size_, end_ - at_)));
    InputFile(path_).read(at_, buffer_.data(), buffer_.size());
    at_ += buffer_.size();
    used_ = 0;
  }
  NewVertex vertex{};
  const auto take = [&](Point& p, std::size_t size) {
    for (double& x : p) {
      x = number_at(buffer_.data() + used_, size);
      used_ += size;
    }
  };
  take(vertex.position, real_size_);
  if (normal_size_ > 0) take(vertex.normal, normal_size_);
  return vertex;
}

}  // namespace tiles
