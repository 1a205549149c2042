// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <support/flat_mesh.h>

namespace test_support {

/// Writes a mesh as binary PLY in single precision, whatever its faces refer to.
inline void write_ply(const FlatMesh& mesh, const std::filesystem::path& path) {
  std::ofstream file(path, std::ios::binary);
  const auto put = [&](auto value) {
    file.write(reinterpret_cast<const char*>(&value), sizeof value);  // these processors are little-endian
  };
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.faces.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& p : mesh.points)
    for (int k = 0; k < 3; ++k) put(static_cast<float>(p[k]));
  for (const Triangle& f : mesh.faces) {
    put(static_cast<unsigned char>(3));
    for (const std::size_t v : f) put(static_cast<std::int32_t>(v));
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace test_support
