// SPDX-License-Identifier: GPL-3.0-or-later
// write_bad_meshes FOLDER: writes the families that a file can hold as binary PLY in single precision, and a table
// families.txt of their names and errors for the tests of whole programs.

#include <filesystem>
#include <fstream>
#include <iostream>

#include <support/bad_meshes.h>
#include <support/write_ply.h>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "write_bad_meshes FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::ofstream table(folder / "families.txt");
  for (const test_support::BadMesh& bad : test_support::bad_meshes<float>()) {
    if (!bad.within_a_file) continue;
    test_support::write_ply(bad.mesh, folder / (bad.name + ".ply"));
    table << bad.name << "\t" << bad.error << "\n";
  }
  return table.flush() ? 0 : 1;
}
