// SPDX-License-Identifier: GPL-3.0-or-later
// write_clean_shapes FOLDER: writes the clean shapes as binary PLY in single precision, for scripts/guided_benchmark.

#include <filesystem>
#include <iostream>

#include <support/clean_shapes.h>
#include <support/write_ply.h>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "write_clean_shapes FOLDER\n";
    return 2;
  }
  try {
    for (const test_support::CleanShape& shape : test_support::clean_shapes())
      test_support::write_ply(shape.mesh, std::filesystem::path(argv[1]) / (shape.name + ".ply"));
  } catch (const std::exception& error) {
    std::cerr << "write_clean_shapes: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
