// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>

namespace durable_files {

/// A file cannot be written; what() is one sentence that says which and why.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The file that a program changes when it writes to `path`: what a symbolic link leads to in the end, whether or not
/// that exists; otherwise `path` itself.
/// @throws WriteError if the links lead in a circle, or the system cannot look at one of them
std::filesystem::path final_target(const std::filesystem::path& path);

/// Puts the complete file `from` into the place of `to`, which is no link and in the same file system. Flushed to the
/// disk before and after, so that a power cut leaves the old file or the new one; where there was a file, the new one
/// gets its permissions.
/// @throws WriteError
void replace_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Flushes the names in a folder to the disk, as far as its file system can.
void flush_folder(const std::filesystem::path& folder);

}  // namespace durable_files
