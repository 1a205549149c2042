// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory_size.h"

#include <charconv>
#include <string_view>
#include <system_error>

#include "command.h"

namespace anisosmooth {

std::uint64_t memory_size(const std::string& text) {
  constexpr std::string_view units = "kmgt";
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string_view unit = std::string_view(text).substr(static_cast<std::size_t>(stop - text.data()));
  if (unit.size() > 1 && (unit.back() == 'B' || unit.back() == 'b')) unit.remove_suffix(1);
  double factor = 1;
  bool is_known = unit.empty();
  for (std::size_t i = 0; i < units.size() && !is_known; ++i) {
    factor *= 1024;
    is_known = unit.size() == 1 && (unit[0] | 0x20) == units[i];
  }
  if (error != std::errc() || !is_known || !(value > 0) || !(value * factor < 1e18))
    throw BadValue("memory is '" + text + "'; allowed is a size above 0, such as 500M or 4G");
  return static_cast<std::uint64_t>(value * factor);
}

}  // namespace anisosmooth
