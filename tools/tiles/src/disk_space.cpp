// SPDX-License-Identifier: GPL-3.0-or-later
#include "disk_space.h"

#include <cstdio>
#include <string>
#include <system_error>

#include <durable_files/replace_file.h>

namespace tiles {

void require_space(const std::filesystem::path& path, const std::filesystem::path& folder, std::uint64_t bytes) {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder.empty() ? "." : folder, error);
  if (error || space.available >= bytes) return;  // what cannot be asked shows when it is written
  throw durable_files::WriteError(path.string() + ": needs " + in_bytes(bytes) + " of disk space, and " +
                                  in_bytes(space.available) + " are free");
}

std::string in_bytes(std::uint64_t bytes) {
  constexpr const char* units[] = {"bytes", "kB", "MB", "GB", "TB"};
  double value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 1000 && unit < 4; ++unit) value /= 1000;
  char text[32];
  std::snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.3g %s", value, units[unit]);
  return text;
}

}  // namespace tiles
