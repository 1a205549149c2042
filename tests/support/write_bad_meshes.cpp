// write_bad_meshes FOLDER: writes the families that a file can hold as binary PLY in single precision, and a table
// families.txt of their names and errors for the tests of whole programs.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <support/bad_meshes.h>

namespace {

using test_support::BadMesh;

template <class Value>
void put(std::ofstream& file, Value value) {
  file.write(reinterpret_cast<const char*>(&value), sizeof value);  // this program's processors are little-endian
}

void write_ply(const BadMesh& bad, const std::filesystem::path& path) {
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << bad.mesh.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << bad.mesh.faces.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const test_support::Point& p : bad.mesh.points)
    for (int k = 0; k < 3; ++k) put(file, static_cast<float>(p[k]));
  for (const test_support::Triangle& f : bad.mesh.faces) {
    put(file, static_cast<unsigned char>(3));
    for (const std::size_t v : f) put(file, static_cast<std::int32_t>(v));
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "write_bad_meshes FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::ofstream table(folder / "families.txt");
  for (const BadMesh& bad : test_support::bad_meshes<float>()) {
    if (!bad.within_a_file) continue;
    write_ply(bad, folder / (bad.name + ".ply"));
    table << bad.name << "\t" << bad.error << "\n";
  }
  return table.flush() ? 0 : 1;
}
