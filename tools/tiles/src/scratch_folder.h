// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tiles {

/// A folder under construction, hidden beside its final place; removed with all that is in it unless it is put there.
class ScratchFolder {
 public:
  /// @param place  where it goes: not there yet, or an empty folder
  /// @throws mesh_tools::FileError
  explicit ScratchFolder(const std::filesystem::path& place);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// @throws mesh_tools::FileError: meanwhile there is something in its place
  void put_in_place();

 private:
  std::filesystem::path place_, path_;
};

}  // namespace tiles
