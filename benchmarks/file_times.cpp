// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a mesh file and writes it with all vertices moved, as the command line does or as vcglib does, and prints the
// processor seconds of both. scripts/bench_files runs it.

#include <sys/resource.h>

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include <mesh_tools/mesh_io.h>
#include <vcg/complex/complex.h>

#include <wrap/io_trimesh/export_obj.h>  // needs complex.h before it
#include <wrap/io_trimesh/export_off.h>
#include <wrap/io_trimesh/export_ply.h>
#include <wrap/io_trimesh/export_stl.h>
#include <wrap/io_trimesh/import_obj.h>
#include <wrap/io_trimesh/import_off.h>
#include <wrap/io_trimesh/import_ply.h>
#include <wrap/io_trimesh/import_stl.h>

namespace {

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The attributes that a mesh of MeshLab's always has, in single precision.
class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3f, vcg::vertex::Normal3f, vcg::vertex::BitFlags,
                                  vcg::vertex::Color4b, vcg::vertex::Qualityf> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::Normal3f, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

struct Times {
  double read, write;
};

Times of_ours(const std::string& from, const std::string& to) {
  const double start = processor_seconds();
  mesh_tools::SourceFile source;
  mesh_tools::FlatFile file = mesh_tools::read_flat(from, &source);
  const double read = processor_seconds();
  for (std::size_t v = 0; v < file.mesh.vertices(); ++v) {
    vcg::Point3d place = file.mesh.position[v];
    for (int k = 0; k < 3; ++k) place[k] *= 1.01;
    file.mesh.position.set(v, place);
  }
  const double moved = processor_seconds();
  mesh_tools::write_moved(file, source, to, false);
  return {read - start, processor_seconds() - moved};
}

Times of_vcglib(const std::string& from, const std::string& to) {
  const double start = processor_seconds();
  Mesh mesh;
  const std::string kind = from.substr(from.rfind('.'));
  int mask = 0;
  if (kind == ".ply")
    vcg::tri::io::ImporterPLY<Mesh>::Open(mesh, from.c_str());
  else if (kind == ".stl")
    vcg::tri::io::ImporterSTL<Mesh>::Open(mesh, from.c_str(), mask);
  else if (kind == ".off")
    vcg::tri::io::ImporterOFF<Mesh>::Open(mesh, from.c_str(), mask);
  else
    vcg::tri::io::ImporterOBJ<Mesh>::Open(mesh, from.c_str(), mask);
  if (mesh.vn == 0) throw std::runtime_error("vcglib cannot read " + from);
  const double read = processor_seconds();
  for (Vertex& vertex : mesh.vert) vertex.P() *= 1.01f;
  const double moved = processor_seconds();
  const bool binary = from.find("text.") == from.npos;
  const int failed = kind == ".ply"   ? vcg::tri::io::ExporterPLY<Mesh>::Save(mesh, to.c_str(), 0, binary)
                     : kind == ".stl" ? vcg::tri::io::ExporterSTL<Mesh>::Save(mesh, to.c_str(), binary)
                     : kind == ".off" ? vcg::tri::io::ExporterOFF<Mesh>::Save(mesh, to.c_str(), 0)
                                      : vcg::tri::io::ExporterOBJ<Mesh>::Save(mesh, to.c_str(), 0);
  if (failed != 0) throw std::runtime_error("vcglib cannot write " + to);
  return {read - start, processor_seconds() - moved};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "file_times ours|vcglib IN OUT: prints the processor seconds of reading and of writing\n");
    return 2;
  }
  try {
    const Times times = argv[1] == std::string("ours") ? of_ours(argv[2], argv[3]) : of_vcglib(argv[2], argv[3]);
    std::printf("%.4f %.4f\n", times.read, times.write);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "file_times: %s\n", error.what());
    return 1;
  }
}
