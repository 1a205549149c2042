// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace durable_files {

/// A file that is read in parts, wherever they lie. It may be replaced or removed meanwhile, by its own result for one:
/// it stays open, and what is read is what was opened. Windows does not replace files that are open; there it is opened
/// for each part.
class InputFile {
 public:
  struct State {
    bool is_regular = false;
    std::uint64_t size = 0;
    std::int64_t modified = 0;  ///< when it was last written, in nanoseconds

    bool operator==(const State& other) const {
      return is_regular == other.is_regular && size == other.size && modified == other.modified;
    }
    bool operator!=(const State& other) const { return !(*this == other); }
  };

  InputFile() = default;
  /// Does not wait for whoever writes to a pipe: what is not regular is opened, and not to be read.
  /// @throws std::system_error
  explicit InputFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  const State& state() const { return state_; }  ///< when it was opened
  State state_now() const;                       ///< @throws std::system_error

  /// Reads `count` bytes from `offset` on.
  /// @return how many there were: fewer only at the file's end
  /// @throws std::system_error
  std::size_t read(std::uint64_t offset, void* bytes, std::size_t count) const;

 private:
  std::filesystem::path path_;
  std::shared_ptr<const int> kept_open_;
  State state_;
};

}  // namespace durable_files
