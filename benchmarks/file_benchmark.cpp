// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line does besides smoothing: reading and writing binary PLY.

#include <filesystem>
#include <string>

#include <unistd.h>

#include <benchmark/benchmark.h>
#include <mesh_tools/mesh_io.h>

#include "bench_mesh.h"

namespace {

/// A mesh in a file that lasts as long as this object.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::size_t vertices)
      : path_(std::filesystem::temp_directory_path() / ("bench_" + std::to_string(::getpid()) + ".ply")) {
    const mesh_tools::Mesh& mesh = bench::noisy_mesh({vertices});
    // vcglib's copy takes what it only reads by a reference that is not const.
    vcg::tri::Append<mesh_tools::Mesh, mesh_tools::Mesh>::MeshCopy(file_.mesh, const_cast<mesh_tools::Mesh&>(mesh));
    file_.precision = mesh_tools::Precision::single_precision;
    write();
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }

  void write() const { mesh_tools::write_mesh(file_, path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  mesh_tools::MeshFile file_;
};

/// Argument: vertices.
void write_ply(benchmark::State& state) {
  const TemporaryFile file(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) file.write();
}
BENCHMARK(write_ply)->Arg(1000000)->Unit(benchmark::kMillisecond);

void read_ply(benchmark::State& state) {
  const TemporaryFile file(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(mesh_tools::read_mesh(file.path()));
}
BENCHMARK(read_ply)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
