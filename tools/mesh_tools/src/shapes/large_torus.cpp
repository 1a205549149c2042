// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/large_torus.h>

#include <array>
#include <cstdint>
#include <string>

#include <durable_files/pending_file.h>
#include <mesh_tools/mesh_io.h>

#include "../io/binary.h"
#include "torus_layout.h"

namespace mesh_tools {
namespace {

using io::append_binary;

class TorusWriter {
 public:
  TorusWriter(std::size_t vertices, bool in_double, const std::filesystem::path& path,
              const std::function<bool()>& interrupted)
      : torus_(vertices), in_double_(in_double), file_(path), interrupted_(interrupted) {}

  LargeTorus run() {
    const std::size_t vertices = static_cast<std::size_t>(torus_.rows) * static_cast<std::size_t>(torus_.columns);
    const std::string real = in_double_ ? "double" : "float";
    bytes_ = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) + "\n";
    for (const char* axis : {"x", "y", "z"}) bytes_ += "property " + real + " " + axis + "\n";
    bytes_ += "element face " + std::to_string(2 * vertices) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for_each_vertex([&](int row, int column) {
      for (const double x : torus_.point(row, column))
        in_double_ ? append_binary(bytes_, x) : append_binary(bytes_, static_cast<float>(x));
    });
    for_each_vertex([&](int row, int column) {
      for (const std::array<int, 3>& face : torus_.faces(row, column)) {
        append_binary(bytes_, std::uint8_t{3});
        for (const int v : face) append_binary(bytes_, std::int32_t{v});
      }
    });
    file_.complete();
    if (interrupted_ && interrupted_()) throw WriteInterrupted();
    file_.put_in_place();
    return {vertices, 2 * vertices};
  }

 private:
  template <class Append>
  void for_each_vertex(const Append& append_one) {
    for (int row = 0; row < torus_.rows; ++row) {
      for (int column = 0; column < torus_.columns; ++column) append_one(row, column);
      if (interrupted_ && interrupted_()) throw WriteInterrupted();
      file_.write(bytes_);
      bytes_.clear();
    }
  }

  shapes::TorusLayout torus_;
  bool in_double_;
  durable_files::PendingFile file_;
  const std::function<bool()>& interrupted_;
  std::string bytes_;
};

}  // namespace

LargeTorus write_large_torus(std::size_t vertices, bool in_double, const std::filesystem::path& path,
                             const std::function<bool()>& interrupted) {
  try {
    return TorusWriter(vertices, in_double, path, interrupted).run();
  } catch (const durable_files::WriteError& error) {
    throw FileError(error.what());
  }
}

}  // namespace mesh_tools
