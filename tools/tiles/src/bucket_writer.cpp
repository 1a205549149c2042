// SPDX-License-Identifier: GPL-3.0-or-later
#include "bucket_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include <durable_files/replace_file.h>

#include "fail.h"

namespace tiles {

BucketWriter::BucketWriter(std::filesystem::path folder, std::string name, std::size_t tiles, std::size_t memory)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      buffer_size_(std::clamp<std::size_t>(memory / tiles, std::size_t(1) << 10, std::size_t(1) << 20)),
      buffer_(tiles) {}

void BucketWriter::add(std::size_t tile, const void* record, std::size_t size) {
  std::string& buffer = buffer_[tile];
  if (buffer.empty()) buffer.reserve(buffer_size_);
  if (buffer.size() + size > buffer_size_) flush(tile);
  buffer.append(static_cast<const char*>(record), size);
}

void BucketWriter::flush() {
  for (std::size_t tile = 0; tile < buffer_.size(); ++tile) {
    flush(tile);
    std::string().swap(buffer_[tile]);
  }
}

void BucketWriter::flush(std::size_t tile) {
  append_to_file(path_of(tile), buffer_[tile].data(), buffer_[tile].size());
  buffer_[tile].clear();
}

std::filesystem::path BucketWriter::path_of(std::size_t tile) const { return folder_ / (name_ + std::to_string(tile)); }

void append_to_file(const std::filesystem::path& path, const void* bytes, std::size_t count) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  file.close();
  if (!file)
    throw durable_files::WriteError(path.string() + ": could not be written to its end: " + std::strerror(errno));
}

}  // namespace tiles
