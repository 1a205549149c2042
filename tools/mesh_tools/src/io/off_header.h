#pragma once

#include <cstdint>

#include "text.h"

namespace mesh_tools::io {

/// What an OFF file declares: its prefixes and counts.
struct OffHeader {
  bool normals = false, colors = false, texture = false;
  std::int64_t vertices = 0, faces = 0;
};

/// Reads the lines up to the first vertex; throws FileError where they are no header.
OffHeader read_off_header(LineReader& reader);

}  // namespace mesh_tools::io
