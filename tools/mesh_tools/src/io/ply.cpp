// PLY: vcglib reads and writes it, after and before checks of our own.

#include <cstring>

#include <mesh_tools/mesh.h>  // first: the headers of vcglib below need it

#include <vcg/complex/algorithms/update/bounding.h>
#include <wrap/io_trimesh/export_ply.h>
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
    if (element.name == "edge" || element.name == "camera" || element.name == "tristrips" ||
        element.name == "range_grid" || element.count == 0)
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

template <class AnyMesh>
int import(AnyMesh& mesh, const PlyLayout& layout, const std::filesystem::path& path) {
  using Importer = vcg::tri::io::ImporterPLY<AnyMesh>;
  int mask = 0;
  const int error = Importer::Open(mesh, path.c_str(), mask);
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
  {
    const std::string bytes = read_bytes(path);
    layout = parse_ply_header(bytes, path);
    check_for_importer(layout, path);
    file.precision = precision_of(*layout.find("vertex"), path);
    check_ply_data(bytes, layout, path);
  }
  const auto* vertex = layout.find("vertex");
  if (file.precision == Precision::single_precision) {
    MeshF mesh;
    file.attributes = import(mesh, layout, path);
    convert(mesh, file.mesh);
  } else {
    file.attributes = import(file.mesh, layout, path);
    if (vertex->find("confidence") && !vertex->find("quality")) {
      // The importer puts the float 'confidence' into half of a double; a float mesh gets it right.
      MeshF mesh;
      import(mesh, layout, path);
      for (std::size_t i = 0; i < mesh.vert.size(); ++i) file.mesh.vert[i].Q() = mesh.vert[i].cQ();
    }
  }
  const std::string unknown = unknown_properties(layout);
  if (!unknown.empty()) file.warnings.push_back(path.string() + ": these properties are not kept: " + unknown);
  vcg::tri::UpdateBounding<Mesh>::Box(file.mesh);
  return file;
}

namespace {

template <class AnyMesh>
bool export_to(AnyMesh& mesh, int attributes, const std::filesystem::path& path) {
  if (vcg::tri::io::ExporterPLY<AnyMesh>::Save(mesh, path.c_str(), attributes & ply_attributes, true) != 0)
    return false;
  try {  // the exporter does not notice when the last bytes do not fit on the disk
    const std::string bytes = read_bytes(path);
    const PlyLayout layout = parse_ply_header(bytes, path);
    check_ply_data(bytes, layout, path);
  } catch (const FileError&) {
    return false;
  }
  return true;
}

}  // namespace

bool write_ply(const MeshFile& file, const std::filesystem::path& path) {
  if (file.precision == Precision::single_precision) {
    MeshF mesh;
    convert(file.mesh, mesh);
    return export_to(mesh, file.attributes, path);
  }
  return export_to(const_cast<Mesh&>(file.mesh), file.attributes, path);  // the exporter only reads
}

}  // namespace mesh_tools::io
