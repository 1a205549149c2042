// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/noisy_shapes.h>

#include <mesh_tools/noise.h>
#include <mesh_tools/shapes.h>

namespace test_support {

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const mesh_tools::Shape& shape : mesh_tools::all_shapes()) names.emplace_back(shape.name);
  return names;
}

FlatMesh noisy_shape(const std::string& name, std::size_t vertices, double noise) {
  const mesh_tools::Mesh clean = mesh_tools::make_shape(name, vertices);
  mesh_tools::Mesh noisy;
  fill(noisy, flat(clean));
  if (noise > 0) mesh_tools::add_noise(noisy, noise, 1, mesh_tools::NoiseDirection::normal);
  return flat(noisy);
}

}  // namespace test_support
