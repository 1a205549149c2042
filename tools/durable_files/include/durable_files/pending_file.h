// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>

#include <durable_files/replace_file.h>

namespace durable_files {

/// A file under construction, hidden beside its final place; removed unless it is put there. Its name is unpredictable
/// and new, so that neither another process nor a planted link can get into it. A link stays a link: what it leads to
/// is replaced, or made if it is not there.
class PendingFile {
 public:
  /// @throws WriteError
  explicit PendingFile(const std::filesystem::path& path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Appends to the file.
  /// @throws WriteError
  void write(std::string_view bytes);

  /// Flushes the file to the disk; to be called once, when all is written.
  /// @throws WriteError
  void complete();

  /// Renames the completed file to its final place, and flushes the folder to the disk. Where there was a file, the new
  /// one has its permissions.
  /// @throws WriteError
  void put_in_place();

 private:
  [[noreturn]] void fail(const char* what, const std::error_code& error) const;

  std::filesystem::path path_;     // as it was given, for messages
  std::filesystem::path target_;   // where it goes
  std::filesystem::path pending_;  // where it is, empty if nowhere
  int file_ = -1;
};

}  // namespace durable_files
