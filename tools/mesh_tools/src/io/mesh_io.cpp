#include <mesh_tools/mesh_io.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

#include <vcg/complex/algorithms/update/normal.h>

#include "formats.h"

namespace mesh_tools {
namespace fs = std::filesystem;
namespace io {

void fail(const fs::path& path, const std::string& what) { throw FileError(path.string() + ": " + what); }

void fail_at_line(const fs::path& path, std::size_t line, const std::string& what) {
  throw FileError(path.string() + ", line " + std::to_string(line) + ": " + what);
}

std::string printable(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return word.size() > longest ? text + "..." : text;
}

bool is_big_endian_machine() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

std::string read_bytes(const fs::path& path) {
  std::error_code error;
  // Anything else could keep the program waiting, or never end.
  if (!fs::is_regular_file(path, error))
    fail(path, "cannot be read: there is no such file, or it is not a regular one");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail(path, std::string("cannot be read: ") + std::strerror(errno));
  std::string bytes;
  bytes.resize(fs::file_size(path, error));
  if (error) fail(path, "cannot be read: " + error.message());
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(stream.gcount()) != bytes.size()) fail(path, "could not be read to its end");
  return bytes;
}

bool write_bytes(const std::string& bytes, const fs::path& path) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  return static_cast<bool>(stream);
}

}  // namespace io

namespace {

constexpr const char* allowed = "allowed are .ply, .obj, .off and .stl";

std::string extension(const fs::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

void check_extension(const fs::path& path) {
  const std::string kind = extension(path);
  if (kind != ".ply" && kind != ".obj" && kind != ".off" && kind != ".stl")
    io::fail(path, kind.empty() ? std::string("has no extension; ") + allowed
                                : "unknown extension '" + kind + "'; " + allowed);
}

void check_place(const fs::path& path) {
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) io::fail(path, "cannot be written: there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    io::fail(path, "cannot be written: folder " + folder.string() + ": " + std::strerror(errno));
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    io::fail(path, "cannot be written: exists and is not a regular file");
  if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0)
    io::fail(path, std::string("cannot be written: ") + std::strerror(errno));
}

/// A file under construction, hidden beside its final place; removed unless it is put there.
class PendingFile {
 public:
  explicit PendingFile(const fs::path& path) {
    std::error_code error;
    target_ = fs::is_symlink(path, error) ? fs::canonical(path, error) : path;
    if (error) target_ = path;
    pending_ = target_.parent_path() / ("." + target_.filename().string() + "." + std::to_string(::getpid()) + ".part");
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    std::error_code error;
    if (!done_) fs::remove(pending_, error);
  }

  const fs::path& path() const { return pending_; }

  void put_in_place() {
    std::error_code error;
    const fs::file_status old = fs::status(target_, error);
    if (fs::is_regular_file(old)) fs::permissions(pending_, old.permissions(), error);
    fs::rename(pending_, target_, error);
    if (error) io::fail(target_, "cannot be written: " + error.message());
    done_ = true;
  }

 private:
  fs::path target_, pending_;
  bool done_ = false;
};

[[noreturn]] void fail_incomplete(const fs::path& path) {
  const int error = errno;  // of the call that failed, if the system told
  io::fail(path, std::string("could not be written to its end: ") +
                     (error != 0 ? std::strerror(error) : "is the disk full?"));
}

void write_pending(const TextFile& file, const PendingFile& pending) {
  errno = 0;
  if (!io::write_bytes(file.text, pending.path())) fail_incomplete(file.path);
}

void check_complete(const Mesh& mesh, const fs::path& path) {
  const auto* first = mesh.vert.data();
  for (std::size_t i = 0; i < mesh.face.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto* vertex = mesh.face[i].cV(k);
      if (std::less<>()(vertex, first) || !std::less<>()(vertex, first + mesh.vert.size()))
        io::fail(path, "face " + std::to_string(i) + " refers to no vertex of the file");
    }
}

struct AttributeName {
  int bits;
  const char* name;
};
constexpr AttributeName attribute_names[] = {{io::vertex_normal, "vertex normals"},
                                             {io::vertex_color, "vertex colours"},
                                             {io::vertex_quality, "vertex quality"},
                                             {io::vertex_texture, "texture coordinates per vertex"},
                                             {io::vertex_radius, "vertex radii"},
                                             {io::vertex_flags | io::face_flags, "flags (selection)"},
                                             {io::face_color, "face colours"},
                                             {io::face_quality, "face quality"},
                                             {io::wedge_texture, "texture coordinates per wedge"},
                                             {io::edges, "edges"},
                                             {io::camera, "camera"}};

std::vector<std::string> lost_attributes(int attributes, int capability, const fs::path& path) {
  std::string names;
  for (const AttributeName& entry : attribute_names)
    if ((attributes & entry.bits) && !(capability & entry.bits))
      names += (names.empty() ? "" : ", ") + std::string(entry.name);
  if (names.empty()) return {};
  return {path.string() + ": the format cannot hold these attributes, they are left out: " + names};
}

}  // namespace

void check_writable(const fs::path& path) {
  check_extension(path);
  check_place(path);
}

void check_text_writable(const fs::path& path) { check_place(path); }

MeshFile read_mesh(const fs::path& path) {
  check_extension(path);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) io::fail(path, "does not exist");
  if (fs::is_directory(status)) io::fail(path, "is a folder; a mesh file is needed");
  if (!fs::is_regular_file(status)) io::fail(path, "is not a regular file");
  if (::access(path.c_str(), R_OK) != 0) io::fail(path, std::string("cannot be read: ") + std::strerror(errno));
  if (fs::file_size(path, error) == 0) io::fail(path, "is empty");
  const std::string kind = extension(path);
  MeshFile file = kind == ".ply"   ? io::read_ply(path)
                  : kind == ".obj" ? io::read_obj(path)
                  : kind == ".off" ? io::read_off(path)
                                   : io::read_stl(path);
  check_complete(file.mesh, path);
  if (file.mesh.vn == 0) io::fail(path, "holds no vertices");
  return file;
}

std::vector<std::string> write_mesh(const MeshFile& file, const fs::path& path,
                                    const std::function<bool()>& interrupted, const TextFile* with) {
  check_writable(path);
  PendingFile pending(path);
  const fs::path material_path = path.string() + ".mtl";
  PendingFile pending_material(material_path);
  io::Companion companion{pending_material.path(), material_path.filename().string()};
  const std::string kind = extension(path);
  int capability = 0;
  bool complete = false;
  errno = 0;
  if (kind == ".ply") {
    capability = io::ply_attributes;
    complete = io::write_ply(file, pending.path());
  } else if (kind == ".obj") {
    capability = io::obj_attributes;
    complete = io::write_obj(file, pending.path(), companion);
  } else if (kind == ".off") {
    capability = io::off_attributes;
    complete = io::write_off(file, pending.path());
  } else {
    capability = io::stl_attributes;
    complete = io::write_stl(file, pending.path());
  }
  if (!complete) fail_incomplete(path);
  std::optional<PendingFile> pending_text;
  if (with) {
    check_place(with->path);
    pending_text.emplace(with->path);
    write_pending(*with, *pending_text);
  }
  if (interrupted && interrupted()) throw WriteInterrupted();
  if (companion.written) pending_material.put_in_place();
  if (pending_text) pending_text->put_in_place();
  pending.put_in_place();
  return lost_attributes(file.attributes, capability, path);
}

void write_text(const TextFile& file, const std::function<bool()>& interrupted) {
  check_place(file.path);
  PendingFile pending(file.path);
  write_pending(file, pending);
  if (interrupted && interrupted()) throw WriteInterrupted();
  pending.put_in_place();
}

void update_normals(Mesh& mesh) {
  vcg::tri::UpdateNormal<Mesh>::PerVertexAngleWeighted(mesh);
  vcg::tri::UpdateNormal<Mesh>::NormalizePerVertex(mesh);
  vcg::tri::UpdateNormal<Mesh>::PerFaceNormalized(mesh);
}

}  // namespace mesh_tools
