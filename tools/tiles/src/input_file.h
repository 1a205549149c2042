// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <durable_files/input_file.h>

namespace tiles {

/// A file that is read in parts, wherever they lie. All throw mesh_tools::FileError.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return file_.path(); }
  std::uint64_t size() const { return file_.state().size; }
  std::int64_t modified() const { return file_.state().modified; }  ///< when it was last written, in nanoseconds

  /// Reads `count` bytes from `offset` on; fewer are an error.
  void read(std::uint64_t offset, void* bytes, std::size_t count) const;

 private:
  durable_files::InputFile file_;
};

/// Reads a range of a file from its beginning to its end, through a buffer.
class SequentialReader {
 public:
  static constexpr std::size_t usual_buffer = std::size_t(1) << 20;

  SequentialReader(const InputFile& file, std::uint64_t begin, std::uint64_t end, std::size_t buffer = usual_buffer);

  /// The next bytes, side by side until the next call; fewer than `count` are an error.
  const char* take(std::size_t count);
  /// As many of the next bytes as the buffer has, at most `most`, at least one, and none only at the end.
  std::size_t take_some(const char*& bytes, std::size_t most);
  std::uint64_t at() const { return next_ - (filled_ - used_); }
  std::uint64_t left() const { return end_ - at(); }

 private:
  void fill(std::size_t least);

  const InputFile& file_;
  std::uint64_t next_, end_;  // of what is not in the buffer yet
  std::vector<char> buffer_;
  std::size_t used_ = 0, filled_ = 0;
};

}  // namespace tiles
