// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace tiles {

/// Throws durable_files::WriteError unless the folder's file system has room for so many bytes.
/// @param path  what is to be written, for the message
void require_space(const std::filesystem::path& path, const std::filesystem::path& folder, std::uint64_t bytes);

/// Bytes as people read them, such as "1.5 GB".
std::string in_bytes(std::uint64_t bytes);

}  // namespace tiles
