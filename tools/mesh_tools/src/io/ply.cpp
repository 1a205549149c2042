// PLY: read by vcglib after a check of our own, written by a writer of our own.

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <type_traits>
#include <utility>

#include <mesh_tools/mesh.h>  // first: the headers of vcglib below need it

#include <vcg/complex/algorithms/update/bounding.h>
#include <wrap/io_trimesh/import_ply.h>

#include "formats.h"
#include "ply_layout.h"

namespace mesh_tools::io {
namespace {

using Type = PlyLayout::Type;

/// What vcglib's importer takes over, by element: a property's name and whether it may be double.
struct KnownProperty {
  const char* name;
  bool floating;
};
constexpr KnownProperty known_of_vertex[] = {{"x", true},
                                             {"y", true},
                                             {"z", true},
                                             {"nx", true},
                                             {"ny", true},
                                             {"nz", true},
                                             {"flags", false},
                                             {"quality", true},
                                             {"confidence", true},
                                             {"radius", true},
                                             {"red", false},
                                             {"green", false},
                                             {"blue", false},
                                             {"alpha", false},
                                             {"diffuse_red", false},
                                             {"diffuse_green", false},
                                             {"diffuse_blue", false},
                                             {"diffuse_alpha", false},
                                             {"intensity", true},
                                             {"s", true},
                                             {"t", true},
                                             {"texture_u", true},
                                             {"texture_v", true},
                                             {"texture_w", true}};
constexpr KnownProperty known_of_face[] = {{"vertex_index", false},
                                           {"vertex_indices", false},
                                           {"flags", false},
                                           {"quality", true},
                                           {"texcoord", true},
                                           {"color", true},
                                           {"texnumber", false},
                                           {"red", false},
                                           {"green", false},
                                           {"blue", false},
                                           {"alpha", false},
                                           {"nx", true},
                                           {"ny", true},
                                           {"nz", true}};

template <std::size_t N>
bool is_known(const PlyLayout::Property& property, const KnownProperty (&table)[N]) {
  const bool is_floating = property.type == Type::float32 || property.type == Type::float64;
  for (const KnownProperty& known : table)
    if (property.name == known.name) return known.floating == is_floating;
  return false;
}

std::string unknown_properties(const PlyLayout& layout) {
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
  for (const auto& element : layout.elements) {
    if (element.name == "edge" || element.name == "tristrips" || element.name == "range_grid" || element.count == 0)
      continue;
    if (element.name != "vertex" && element.name != "face") {
      add(element.name);
      continue;
    }
    for (const auto& property : element.properties)
      if (!(element.name == "vertex" ? is_known(property, known_of_vertex) : is_known(property, known_of_face)))
        add(element.name + "." + property.name);
  }
  return names;
}

Precision precision_of(const PlyLayout::Element& vertex, const std::filesystem::path& path) {
  Type types[3];
  for (int k = 0; k < 3; ++k) {
    const std::string name(1, static_cast<char>('x' + k));
    const auto* property = vertex.find(name);
    if (!property || property->is_list || (property->type != Type::float32 && property->type != Type::float64))
      fail(path, "vertex property '" + name + "' must be there and be float or double");
    types[k] = property->type;
  }
  if (types[0] != types[1] || types[0] != types[2]) fail(path, "vertex properties x, y, z must be of one type");
  return types[0] == Type::float32 ? Precision::single_precision : Precision::double_precision;
}

void check_for_importer(const PlyLayout& layout, const std::filesystem::path& path) {
  const auto* vertex = layout.find("vertex");
  if (!vertex) fail(path, "declares no vertices");
  for (const auto& element : layout.elements) {
    if (element.name == "vertex") break;
    if (element.name == "face" || element.name == "tristrips" || element.name == "edge")
      fail(path, "declares element '" + element.name + "' before the vertices");
  }
  for (const std::string& comment : layout.comments)
    if (comment.size() > 200 && comment.rfind("Texture", 0) == 0)
      fail(path, "names a texture in more than 200 characters");
}

/// A file in the folder for temporary files, removed at the end.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& bytes) {
    std::string name = (std::filesystem::temp_directory_path() / "mesh_tools_XXXXXX").string();
    const int descriptor = ::mkstemp(name.data());
    path_ = name;
    const bool written = descriptor >= 0 && write_bytes(bytes, path_);
    if (descriptor >= 0) ::close(descriptor);
    if (!written) fail(path_, "a temporary file cannot be written");
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code error;
    std::filesystem::remove(path_, error);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

template <class AnyMesh>
int import(AnyMesh& mesh, const PlyLayout& layout, const std::filesystem::path& source,
           const std::filesystem::path& path) {
  using Importer = vcg::tri::io::ImporterPLY<AnyMesh>;
  int mask = 0;
  const int error = Importer::Open(mesh, source.c_str(), mask);
  if (error != 0 && Importer::ErrorCritical(error))
    fail(path, std::string("cannot be read: ") + Importer::ErrorMsg(error));
  const auto *vertex = layout.find("vertex"), *face = layout.find("face");
  if (mesh.vert.size() != vertex->count || (face && mesh.face.size() < face->count))
    fail(path, face && mesh.face.empty()
                   ? std::string("the type of its faces' 'vertex_indices' is not supported; use list uchar int")
                   : std::string("was not read to its end"));
  // Flags come from the file; none of its elements is deleted.
  for (auto& element : mesh.vert) element.ClearD();
  for (auto& element : mesh.face) element.ClearD();
  mesh.vn = static_cast<int>(mesh.vert.size());
  mesh.fn = static_cast<int>(mesh.face.size());
  return mask;
}

}  // namespace

MeshFile read_ply(const std::filesystem::path& path) {
  MeshFile file;
  PlyLayout layout;
  std::optional<ScratchFile> swapped;  // vcglib's reader does not turn the bytes of a double
  {
    const std::string bytes = read_bytes(path);
    layout = parse_ply_header(bytes, path);
    check_for_importer(layout, path);
    file.precision = precision_of(*layout.find("vertex"), path);
    check_ply_data(bytes, layout, path);
    if (layout.format == PlyLayout::Format::big_endian) swapped.emplace(to_little_endian(bytes, layout));
  }
  const std::filesystem::path& source = swapped ? swapped->path() : path;
  const auto* vertex = layout.find("vertex");
  if (file.precision == Precision::single_precision) {
    MeshF mesh;
    file.attributes = import(mesh, layout, source, path);
    convert(mesh, file.mesh);
  } else {
    file.attributes = import(file.mesh, layout, source, path);
    if (vertex->find("confidence") && !vertex->find("quality")) {
      // The importer puts the float 'confidence' into half of a double; a float mesh gets it right.
      MeshF mesh;
      import(mesh, layout, source, path);
      for (std::size_t i = 0; i < mesh.vert.size(); ++i) file.mesh.vert[i].Q() = mesh.vert[i].cQ();
    }
  }
  const std::string unknown = unknown_properties(layout);
  if (!unknown.empty()) file.warnings.push_back(path.string() + ": these properties are not kept: " + unknown);
  vcg::tri::UpdateBounding<Mesh>::Box(file.mesh);
  return file;
}

namespace {

/// Writes as vcglib's exporter does, by the same names and types. That one is not used, for in double precision it
/// writes texture coordinates of vertices in another type than it declares.
template <class AnyMesh>
class PlyText {
 public:
  PlyText(const AnyMesh& mesh, int attributes) : mesh_(mesh), attributes_(attributes) {}

  std::string bytes() {
    append_header();
    std::vector<std::int32_t> number(mesh_.vert.size());
    std::int32_t count = 0;
    for (std::size_t i = 0; i < mesh_.vert.size(); ++i) {
      if (mesh_.vert[i].IsD()) continue;
      number[i] = count++;
      append_vertex(mesh_.vert[i]);
    }
    for (const auto& face : mesh_.face)
      if (!face.IsD()) append_face(face, number);
    for (const auto& edge : mesh_.edge)
      if (has(edges) && !edge.IsD())
        for (int k = 0; k < 2; ++k) append(number[vcg::tri::Index(mesh_, edge.cV(k))]);
    return std::move(bytes_);
  }

 private:
  using Scalar = typename AnyMesh::ScalarType;
  static constexpr const char* scalar = std::is_same_v<Scalar, float> ? "float" : "double";

  bool has(int attribute) const { return (attributes_ & attribute) != 0; }
  bool has_pages() const { return has(wedge_texture) && mesh_.textures.size() > 1; }

  void declare(const std::string& type, std::initializer_list<const char*> names) {
    for (const char* name : names) bytes_ += "property " + type + " " + name + "\n";
  }

  void append_header() {
    bytes_ = "ply\nformat binary_little_endian 1.0\n";
    if (has(vertex_texture | wedge_texture))
      for (const std::string& texture : mesh_.textures) bytes_ += "comment TextureFile " + texture + "\n";
    bytes_ += "element vertex " + std::to_string(mesh_.vn) + "\n";
    declare(scalar, {"x", "y", "z"});
    if (has(vertex_normal)) declare(scalar, {"nx", "ny", "nz"});
    if (has(vertex_flags)) declare("int", {"flags"});
    if (has(vertex_color)) declare("uchar", {"red", "green", "blue", "alpha"});
    if (has(vertex_quality)) declare(scalar, {"quality"});
    if (has(vertex_radius)) declare("float", {"radius"});
    if (has(vertex_texture)) declare("float", {"texture_u", "texture_v"});
    bytes_ += "element face " + std::to_string(mesh_.fn) + "\n";
    declare("list uchar int", {"vertex_indices"});
    if (has(face_flags)) declare("int", {"flags"});
    if (has(wedge_texture)) declare("list uchar float", {"texcoord"});
    if (has_pages()) declare("int", {"texnumber"});
    if (has(face_color)) declare("uchar", {"red", "green", "blue", "alpha"});
    if (has(face_normal)) declare(scalar, {"nx", "ny", "nz"});
    if (has(face_quality)) declare(scalar, {"quality"});
    if (has(edges)) {
      bytes_ += "element edge " + std::to_string(mesh_.en) + "\n";
      declare("int", {"vertex1", "vertex2"});
    }
    bytes_ += "end_header\n";
  }

  template <class Value>
  void append(Value value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (is_big_endian_machine()) std::reverse(raw, raw + sizeof value);
    bytes_.append(raw, sizeof value);
  }

  template <class Point>
  void append_point(const Point& p) {
    for (int k = 0; k < 3; ++k) append(static_cast<Scalar>(p[k]));
  }

  void append_color(const vcg::Color4b& color) {
    for (int k = 0; k < 4; ++k) append(color[k]);
  }

  template <class AnyVertex>
  void append_vertex(const AnyVertex& vertex) {
    append_point(vertex.cP());
    if (has(vertex_normal)) append_point(vertex.cN());
    if (has(vertex_flags)) append(static_cast<std::int32_t>(vertex.cFlags()));
    if (has(vertex_color)) append_color(vertex.cC());
    if (has(vertex_quality)) append(static_cast<Scalar>(vertex.cQ()));
    if (has(vertex_radius)) append(static_cast<float>(vertex.cR()));
    if (has(vertex_texture)) {
      append(static_cast<float>(vertex.cT().u()));
      append(static_cast<float>(vertex.cT().v()));
    }
  }

  template <class AnyFace>
  void append_face(const AnyFace& face, const std::vector<std::int32_t>& number) {
    append(static_cast<unsigned char>(3));
    for (int k = 0; k < 3; ++k) append(number[vcg::tri::Index(mesh_, face.cV(k))]);
    if (has(face_flags)) append(static_cast<std::int32_t>(face.cFlags()));
    if (has(wedge_texture)) {
      append(static_cast<unsigned char>(6));
      for (int k = 0; k < 3; ++k) {
        append(static_cast<float>(face.cWT(k).u()));
        append(static_cast<float>(face.cWT(k).v()));
      }
    }
    if (has_pages()) append(static_cast<std::int32_t>(face.cWT(0).n()));
    if (has(face_color)) append_color(face.cC());
    if (has(face_normal)) append_point(face.cN());
    if (has(face_quality)) append(static_cast<Scalar>(face.cQ()));
  }

  const AnyMesh& mesh_;
  int attributes_;
  std::string bytes_;
};

}  // namespace

bool write_ply(const MeshFile& file, const std::filesystem::path& path) {
  if (file.precision == Precision::double_precision)
    return write_bytes(PlyText<Mesh>(file.mesh, file.attributes).bytes(), path);
  MeshF mesh;
  convert(file.mesh, mesh);
  return write_bytes(PlyText<MeshF>(mesh, file.attributes).bytes(), path);
}

}  // namespace mesh_tools::io
