// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

namespace test_support {

/// The memory of a vcglib mesh's elements, byte for byte: positions, flags, attributes, references. (Optional
/// components lie elsewhere.) Of its use to see that a call changed nothing; the mesh must not be moved in between.
template <class Mesh>
class RawSnapshot {
 public:
  explicit RawSnapshot(const Mesh& mesh) : mesh_(mesh), vertices_(bytes(mesh.vert)), faces_(bytes(mesh.face)) {}

  /// Whether the mesh is bit for bit as it was.
  bool unchanged() const { return vertices_ == bytes(mesh_.vert) && faces_ == bytes(mesh_.face); }

 private:
  template <class Container>
  static std::vector<unsigned char> bytes(const Container& elements) {
    std::vector<unsigned char> copy(elements.size() * sizeof(typename Container::value_type));
    if (!copy.empty()) std::memcpy(copy.data(), static_cast<const void*>(elements.data()), copy.size());
    return copy;
  }

  const Mesh& mesh_;
  std::vector<unsigned char> vertices_;
  std::vector<unsigned char> faces_;
};

}  // namespace test_support
