// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tiles {

/// Appends records to one file for each tile, a buffer at a time and with one file open at a time, so that tiles may be
/// many. Throws durable_files::WriteError.
class BucketWriter {
 public:
  /// @param name    of the files, before the number of the tile
  /// @param memory  bytes for all buffers
  BucketWriter(std::filesystem::path folder, std::string name, std::size_t tiles, std::size_t memory);

  void add(std::size_t tile, const void* record, std::size_t size);
  /// To be called at the end.
  void flush();

  std::filesystem::path path_of(std::size_t tile) const;

 private:
  void flush(std::size_t tile);

  std::filesystem::path folder_;
  std::string name_;
  std::size_t buffer_size_;
  std::vector<std::string> buffer_;
};

/// Appends to a file, or makes it.
/// @throws durable_files::WriteError
void append_to_file(const std::filesystem::path& path, const void* bytes, std::size_t count);

}  // namespace tiles
