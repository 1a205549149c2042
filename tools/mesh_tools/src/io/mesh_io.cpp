// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesh_tools/mesh_io.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <list>
#include <system_error>
#include <utility>

#include <durable_files/access.h>
#include <durable_files/pending_file.h>
#include <vcg/complex/algorithms/update/normal.h>

#include "byte_source.h"
#include "file_names.h"
#include "formats.h"
#include "polygons.h"
#include "splice/splice.h"

namespace mesh_tools {
namespace fs = std::filesystem;
namespace io {

void fail(const fs::path& path, const std::string& what) { throw FileError(path.string() + ": " + what); }

void fail_at_line(const fs::path& path, std::size_t line, const std::string& what) {
  throw FileError(path.string() + ", line " + std::to_string(line) + ": " + what);
}

void note_small_faces(std::size_t count, const fs::path& path, FlatFile& file) {
  if (count > 0)
    file.warnings.push_back(path.string() + ": " + std::to_string(count) +
                            (count == 1 ? " face has fewer than 3 corners; it is passed over"
                                        : " faces have fewer than 3 corners; they are passed over"));
}

std::string printable(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return word.size() > longest ? text + "..." : text;
}

void check_same_count(const fs::path& path, const char* what, std::size_t read, std::size_t found) {
  if (read == found) return;
  fail(path, "cannot be written with other coordinates: " + std::to_string(read) + " " + what +
                 " were read from it, and " + std::to_string(found) + " are found in it");
}

}  // namespace io

std::string extension(const fs::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

namespace {

constexpr const char* allowed = "allowed are .ply, .obj, .off, .stl, .glb and .gltf";

bool is_gltf(const std::string& kind) { return kind == ".glb" || kind == ".gltf"; }

void check_extension(const fs::path& path) {
  const std::string kind = extension(path);
  if (!has_known_extension(path))
    io::fail(path, kind.empty() ? std::string("has no extension; ") + allowed
                                : "unknown extension '" + kind + "'; " + allowed);
}

void check_place(const fs::path& path) {
  std::error_code error;
  const fs::path target = durable_files::final_target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) io::fail(path, "cannot be written: there is no folder " + folder.string());
  if (const std::error_code denied = durable_files::check_folder_writable(folder))
    io::fail(path, "cannot be written: folder " + folder.string() + ": " + denied.message());
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    io::fail(path, "cannot be written: exists and is not a regular file");
  if (!fs::exists(status)) return;
  if (const std::error_code denied = durable_files::check_writable(target))
    io::fail(path, "cannot be written: " + denied.message());
}

/// Does `write` with its errors as this library's.
template <class Function>
void as_file_errors(Function write) {
  try {
    write();
  } catch (const durable_files::WriteError& error) {
    throw FileError(error.what());
  }
}

/// A file, and what writes it, part by part.
struct Writing {
  fs::path path;
  std::function<void(durable_files::PendingFile&)> write;
};

Writing writing_of(TextFile file) {
  return {std::move(file.path),
          [text = std::move(file.text)](durable_files::PendingFile& pending) { pending.write(text); }};
}

/// Writes files that appear together: all are complete and on the disk before the first gets its name, in this order.
void write_together(const std::vector<Writing>& files, const std::function<bool()>& interrupted) {
  as_file_errors([&] {
    std::list<durable_files::PendingFile> pending;
    for (const Writing& file : files) {
      check_place(file.path);
      pending.emplace_back(file.path);
      file.write(pending.back());
      pending.back().complete();
    }
    if (interrupted && interrupted()) throw WriteInterrupted();
    for (durable_files::PendingFile& file : pending) file.put_in_place();
  });
}

void check_complete(const FlatMesh& mesh, const fs::path& path) {
  // Corners are counted in 32 bits.
  constexpr std::size_t most_faces = std::numeric_limits<std::uint32_t>::max() / 3;
  if (mesh.face.size() > most_faces)
    io::fail(path, "has " + std::to_string(mesh.face.size()) + " triangles; at most " + std::to_string(most_faces) +
                       " can be read");
  for (std::size_t f = 0; f < mesh.face.size(); ++f)
    for (const std::uint32_t v : mesh.face[f])
      if (v >= mesh.vertices()) io::fail(path, "face " + std::to_string(f) + " refers to no vertex of the file");
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

bool has_known_extension(const fs::path& path) {
  const std::string kind = extension(path);
  return kind == ".ply" || kind == ".obj" || kind == ".off" || kind == ".stl" || is_gltf(kind);
}

std::string known_extensions() { return allowed; }

void check_writable(const fs::path& path, const fs::path& from) {
  check_extension(path);
  if (const std::string kind = extension(path); is_gltf(kind) && extension(from) != kind)
    io::fail(path, "cannot be written: a " + kind + " file is only written as a copy of one that was read");
  check_text_writable(path);
}

void check_text_writable(const fs::path& path) {
  as_file_errors([&] { check_place(path); });
}

std::vector<fs::path> files_of(const fs::path& path) {
  const std::string kind = extension(path);
  if (kind != ".obj" && kind != ".gltf") return {path};
  return {path, path.string() + (kind == ".obj" ? ".mtl" : ".bin")};
}

namespace {

void check_readable(const fs::path& path) {
  check_extension(path);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) io::fail(path, "does not exist");
  if (fs::is_directory(status)) io::fail(path, "is a folder; a mesh file is needed");
  if (!fs::is_regular_file(status)) io::fail(path, "is not a regular file");
  if (const std::error_code denied = durable_files::check_readable(path))
    io::fail(path, "cannot be read: " + denied.message());
  if (fs::file_size(path, error) == 0) io::fail(path, "is empty");
}

FlatFile read_from(io::ByteSource& bytes, const fs::path& path) {
  const std::string kind = extension(path);
  FlatFile file = kind == ".ply"   ? io::read_ply(bytes.whole(), path)
                  : kind == ".obj" ? io::read_obj(bytes.whole(), path)
                  : kind == ".off" ? io::read_off(bytes.whole(), path)
                  : kind == ".stl" ? io::read_stl(bytes, path)
                                   : io::read_gltf(bytes.whole(), path);
  check_complete(file.mesh, path);
  io::cut_polygons(file);
  if (file.mesh.vertices() == 0) io::fail(path, "holds no vertices");
  file.folder = path.parent_path();
  return file;
}

}  // namespace

MeshFile read_mesh(const fs::path& path, OriginalFile* original) {
  check_readable(path);
  std::string bytes = SourceFile(path).read();
  io::BytesInMemory in_memory(bytes);
  FlatFile file = read_from(in_memory, path);
  if (original)
    *original = {path, std::move(bytes)};
  else
    std::string().swap(bytes);
  return to_vcglib(std::move(file));
}

FlatFile read_flat(const fs::path& path, SourceFile* source) {
  check_readable(path);
  SourceFile opened(path);
  io::BytesOfFile bytes(opened);
  FlatFile file = read_from(bytes, path);
  if (source) *source = std::move(opened);
  return file;
}

std::vector<std::string> write_mesh(const MeshFile& file, const fs::path& path,
                                    const std::function<bool()>& interrupted, const TextFile* with) {
  return write_mesh(to_flat(file), path, interrupted, with);
}

std::vector<std::string> write_mesh(const FlatFile& file, const fs::path& path,
                                    const std::function<bool()>& interrupted, const TextFile* with) {
  check_writable(path);
  const std::string kind = extension(path);
  int capability = 0;
  std::string bytes;
  std::vector<Writing> together;
  std::vector<std::string> textures = file.mesh.textures;
  if (file.folder)
    for (std::string& name : textures) name = io::moved_file_name(name, *file.folder, path.parent_path());
  if (kind == ".ply") {
    capability = io::ply_attributes;
    bytes = io::ply_bytes(file, textures);
  } else if (kind == ".obj") {
    capability = io::obj_attributes;
    const fs::path material_path = files_of(path).back();
    io::ObjBytes obj = io::obj_bytes(file, textures, material_path.filename().string());
    bytes = std::move(obj.mesh);
    if (!obj.materials.empty()) together.push_back(writing_of({material_path, std::move(obj.materials)}));
  } else if (kind == ".off") {
    capability = io::off_attributes;
    bytes = io::off_bytes(file);
  } else {
    capability = io::stl_attributes;
    bytes = io::stl_bytes(file);
  }
  if (with) together.push_back(writing_of(*with));
  together.push_back(writing_of({path, std::move(bytes)}));  // last: who sees the mesh finds the others
  write_together(together, interrupted);
  std::vector<std::string> lost = file.not_kept;
  const std::size_t polygons = file.polygons.polygons.size();
  if (kind == ".stl" && polygons > 0)
    lost.push_back(path.string() + ": " + std::to_string(polygons) +
                   (polygons == 1 ? " polygon was" : " polygons were") + " cut into triangles");
  for (std::string& sentence : lost_attributes(file.attributes, capability, path)) lost.push_back(std::move(sentence));
  return lost;
}

namespace {

/// With normals that follow from the positions.
std::vector<std::string> write_anew(FlatFile& file, const fs::path& path, const std::function<bool()>& interrupted,
                                    const TextFile* with) {
  if (file.attributes & normal_attributes) update_normals(file.mesh);
  return write_mesh(file, path, interrupted, with);
}

/// The original's bytes with other numbers: what writes them while the arguments live.
std::vector<Writing> spliced(io::ByteSource& bytes, const io::SpliceInput& input, const fs::path& path) {
  const std::string kind = extension(path);
  if (is_gltf(kind)) {
    io::SplicedFiles files = io::splice_gltf(std::move(bytes.whole()), input, path);
    std::vector<Writing> writings;
    for (TextFile& beside : files.beside) writings.push_back(writing_of(std::move(beside)));
    writings.push_back(writing_of({path, std::move(files.mesh)}));
    return writings;
  }
  return {{path, [&bytes, input, path, kind](durable_files::PendingFile& pending) {
             const io::Write write = [&pending](std::string_view part) { pending.write(part); };
             if (kind == ".ply")
               io::splice_ply(bytes.whole(), input, path, write);
             else if (kind == ".obj")
               io::splice_obj(bytes.whole(), input, path, write);
             else if (kind == ".off")
               io::splice_off(bytes.whole(), input, write);
             else
               io::splice_stl(bytes, input, write);
           }}};
}

/// With the original's bytes and other numbers, where they have room for them.
std::vector<std::string> write_spliced(FlatFile& file, io::ByteSource& bytes, const fs::path& from,
                                       const fs::path& path, bool recolored, const std::function<bool()>& interrupted,
                                       const TextFile* with) {
  const io::SpliceInput input{file, from, recolored};
  try {
    std::vector<Writing> together = spliced(bytes, input, path);
    if (with) together.insert(together.begin(), writing_of(*with));
    write_together(together, interrupted);
  } catch (const io::NoRoom& reason) {
    std::vector<std::string> lost = write_anew(file, path, interrupted, with);
    lost.insert(lost.begin(), from.string() + ": " + reason.what());
    return lost;
  }
  return {};
}

}  // namespace

std::vector<std::string> write_moved(MeshFile& file, OriginalFile original, const fs::path& path, bool recolored,
                                     const std::function<bool()>& interrupted, const TextFile* with) {
  FlatFile flat = to_flat(file);
  if (extension(path) != extension(original.path)) return write_anew(flat, path, interrupted, with);
  check_writable(path, original.path);
  io::BytesInMemory bytes(original.bytes);
  return write_spliced(flat, bytes, original.path, path, recolored, interrupted, with);
}

std::vector<std::string> write_moved(FlatFile& file, const SourceFile& source, const fs::path& path, bool recolored,
                                     const std::function<bool()>& interrupted, const TextFile* with) {
  if (extension(path) != extension(source.path())) return write_anew(file, path, interrupted, with);
  check_writable(path, source.path());
  if (!source.has_changed()) {
    io::BytesOfFile bytes(source);
    return write_spliced(file, bytes, source.path(), path, recolored, interrupted, with);
  }
  const std::string what = "has changed since it was read";
  if (is_gltf(extension(path))) io::fail(source.path(), what);
  std::vector<std::string> lost = write_anew(file, path, interrupted, with);
  lost.insert(lost.begin(), source.path().string() + ": " + what + ", so the result is written anew");
  return lost;
}

void write_text(const TextFile& file, const std::function<bool()>& interrupted) {
  write_together({writing_of(file)}, interrupted);
}

void update_normals(Mesh& mesh) {
  vcg::tri::UpdateNormal<Mesh>::PerVertexAngleWeighted(mesh);
  vcg::tri::UpdateNormal<Mesh>::NormalizePerVertex(mesh);
  vcg::tri::UpdateNormal<Mesh>::PerFaceNormalized(mesh);
}

}  // namespace mesh_tools
