// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <durable_files/input_file.h>

/// What systems do each in their own way with files: system_posix.cpp and system_windows.cpp.
namespace durable_files::system {

/// Creates a file that is not there yet, and opens it for writing. Where `replaced` is a regular file, nobody may ever
/// read the new one who may not read that, and the new one gets its permissions.
/// @return a number for the functions below; -1 if that failed
int create(const std::filesystem::path& path, const std::filesystem::path& replaced, std::error_code& error);

/// Opens a file for reading, without waiting for anybody.
/// @return a number for the functions below; -1 if that failed
int open(const std::filesystem::path& path, std::error_code& error);

InputFile::State state_of(int file, std::error_code& error);

/// Reads at most `count` bytes, at least one but at the file's end.
std::size_t read(int file, std::uint64_t offset, char* bytes, std::size_t count, std::error_code& error);

/// Whether a file may be replaced while it is open.
extern const bool replaces_open_files;

std::error_code write(int file, std::string_view bytes);

/// Flushes an open file to the disk. No error where the file system cannot.
std::error_code flush(int file);

std::error_code close(int file);

/// Flushes a file to the disk and gives it the permissions of `replaced`, if that is there.
std::error_code flush(const std::filesystem::path& path, const std::filesystem::path& replaced);

/// Renames a file, over another if there is one: at any time one of them has the new name.
std::error_code rename(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace durable_files::system
