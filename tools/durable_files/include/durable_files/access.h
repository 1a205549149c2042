// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <system_error>

namespace durable_files {

/// Whether this process may read a file, write to it, or make files in a folder: no error if so.
std::error_code check_readable(const std::filesystem::path& file);
std::error_code check_writable(const std::filesystem::path& file);
std::error_code check_folder_writable(const std::filesystem::path& folder);

}  // namespace durable_files
