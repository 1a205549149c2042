// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <vcg/space/point3.h>

namespace tools_tests {

/// Vertices of a file: where they were when it was made, and where they are now.
struct Places {
  std::vector<vcg::Point3d> before, now;
};

/// Files of a layout that follows from the seed alone: order, types, white space, comments, things that no reader
/// knows. A coordinate that is the same before and now is written in some odd way, another one as its shortest text. So
/// the file of {before, before} is what the file of {before, now} was when nothing had moved yet. No normals.
/// @param places  exact in single precision; of STL all different; at least 3
std::string random_ply(std::uint64_t seed, const Places& places);
std::string random_obj(std::uint64_t seed, const Places& places);
std::string random_off(std::uint64_t seed, const Places& places);
/// Text; facets are without direction in the file: "0 0 0".
std::string random_stl(std::uint64_t seed, const Places& places);

/// Random places, of which about a third of the coordinates move.
Places random_places(std::uint64_t seed, std::size_t count);

}  // namespace tools_tests
