// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace anisosmooth {

/// Bytes from a text such as "4G", "500M" or "1.5g": with K, M, G or T in multiples of 1024.
/// @throws BadValue
std::uint64_t memory_size(const std::string& text);

}  // namespace anisosmooth
