// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the triangles of a glTF file, and where the numbers of their vertices are.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "../formats.h"
#include "gltf_file.h"

namespace mesh_tools::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using vcg::Matrix44d;

class GltfReader {
 public:
  GltfReader(const GltfFile& file, const fs::path& path) : file_(file), path_(path) {}

  GltfMesh read() {
    refuse_extensions();
    find_transforms();
    const json* const meshes = array(*file_.json, "meshes");
    for (std::size_t m = 0; meshes && m < meshes->size(); ++m) {
      const json* const primitives = array((*meshes)[m], "primitives");
      for (std::size_t p = 0; primitives && p < primitives->size(); ++p) {
        where_ = "mesh " + std::to_string(m) + ", primitive " + std::to_string(p);
        read_primitive((*primitives)[p], m);
      }
    }
    for (const auto& [accessor, other] : other_normals_)
      mesh_.warnings.push_back("positions of accessor " + std::to_string(accessor) + " are used with several sets of " +
                               "normals; only the first is made anew");
    if (other_kinds_ > 0)
      mesh_.warnings.push_back(std::to_string(other_kinds_) + " primitives are points or lines; they stay as they are");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { fail(path_, where_ + ": " + what); }

  // JSON. What is not as it must be is as if it was not there, or an error where a number is expected.

  static const json* member(const json& object, const char* name) {
    const auto found = object.is_object() ? object.find(name) : object.end();
    return found == object.end() ? nullptr : &*found;
  }
  static const json* array(const json& object, const char* name) {
    const json* const found = member(object, name);
    return found && found->is_array() ? found : nullptr;
  }
  static bool has(const json& object, const char* name) { return member(object, name) != nullptr; }

  std::size_t number(const json& value, const char* name) const {
    if (!value.is_number_integer() || value < 0) refuse(std::string(name) + " is no whole number from 0 on");
    return value.get<std::size_t>();
  }
  std::size_t number(const json& object, const char* name, std::optional<std::size_t> otherwise) const {
    const json* const value = member(object, name);
    if (!value && !otherwise) refuse(std::string("has no ") + name);
    return value ? number(*value, name) : *otherwise;
  }
  std::string text(const json& object, const char* name) const {
    const json* const value = member(object, name);
    return value && value->is_string() ? value->get<std::string>() : std::string();
  }
  /// Element `index` of one of the file's lists.
  const json& element(const char* list, std::size_t index) const {
    const json* const elements = array(*file_.json, list);
    if (!elements || index >= elements->size())
      refuse("refers to " + std::string(list) + " " + std::to_string(index) + "; there are " +
             std::to_string(elements ? elements->size() : 0));
    return (*elements)[index];
  }

  void refuse_extensions() const {
    const json* const required = array(*file_.json, "extensionsRequired");
    for (std::size_t i = 0; required && i < required->size(); ++i)
      for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"})
        if ((*required)[i] == name) fail(path_, std::string("needs ") + name + ", which cannot be changed in place");
  }

  // Where meshes are in the world.

  Matrix44d transform_of(const json& node) const {
    Matrix44d result;
    result.SetIdentity();
    const auto numbers = [&](const char* name, std::size_t count) -> const json* {
      const json* const list = array(node, name);
      const bool fits = list && list->size() == count &&
                        std::all_of(list->begin(), list->end(), [](const json& value) { return value.is_number(); });
      if (list && !fits) refuse(std::string(name) + " is not " + std::to_string(count) + " numbers");
      return list;
    };
    if (const json* const matrix = numbers("matrix", 16)) {
      for (int i = 0; i < 16; ++i)
        result.ElementAt(i % 4, i / 4) = (*matrix)[static_cast<std::size_t>(i)].get<double>();
      return result;
    }
    if (const json* const r = numbers("rotation", 4)) {
      const double x = (*r)[0], y = (*r)[1], z = (*r)[2], w = (*r)[3];
      const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                                 {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                                 {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) result.ElementAt(i, k) = rows[i][k];
    }
    if (const json* const scale = numbers("scale", 3))
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) result.ElementAt(i, k) *= (*scale)[static_cast<std::size_t>(k)].get<double>();
    if (const json* const move = numbers("translation", 3))
      for (int i = 0; i < 3; ++i) result.ElementAt(i, 3) = (*move)[static_cast<std::size_t>(i)].get<double>();
    return result;
  }

  /// From each node that is nobody's child down; of several nodes with one mesh the first counts.
  void find_transforms() {
    const json* const nodes = array(*file_.json, "nodes");
    if (!nodes) return;
    std::vector<bool> is_child(nodes->size(), false), is_seen(nodes->size(), false);
    const auto children = [&](std::size_t node) {
      std::vector<std::size_t> result;
      const json* const list = array((*nodes)[node], "children");
      for (std::size_t i = 0; list && i < list->size(); ++i) {
        result.push_back(number((*list)[i], "children"));
        if (result.back() >= nodes->size()) refuse("has a child that is not there");
      }
      return result;
    };
    for (std::size_t n = 0; n < nodes->size(); ++n) {
      where_ = "node " + std::to_string(n);
      for (const std::size_t child : children(n)) is_child[child] = true;
    }
    Matrix44d identity;
    identity.SetIdentity();
    std::vector<std::pair<std::size_t, Matrix44d>> open;
    for (std::size_t n = nodes->size(); n-- > 0;)
      if (!is_child[n]) open.emplace_back(n, identity);
    while (!open.empty()) {
      const auto [n, above] = open.back();
      open.pop_back();
      if (is_seen[n]) continue;
      is_seen[n] = true;
      where_ = "node " + std::to_string(n);
      const Matrix44d here = above * transform_of((*nodes)[n]);
      if (has((*nodes)[n], "mesh")) to_world_.try_emplace(number((*nodes)[n], "mesh", {}), here);
      const std::vector<std::size_t> below = children(n);
      for (auto child = below.rbegin(); child != below.rend(); ++child) open.emplace_back(*child, here);
    }
  }

  // Numbers in buffers.

  struct Rows {
    std::size_t buffer, offset, stride, count;
  };

  /// The rows of an accessor, of `size` bytes each, all of them within its buffer.
  Rows rows_of(const json& accessor, const char* name, std::size_t size) const {
    if (has(accessor, "sparse")) refuse(std::string(name) + " are sparse, which cannot be changed in place");
    if (!has(accessor, "bufferView")) refuse(std::string(name) + " have no buffer view");
    const json& view = element("bufferViews", number(accessor, "bufferView", {}));
    if (const json* const extensions = member(view, "extensions");
        extensions && has(*extensions, "EXT_meshopt_compression"))
      refuse(std::string(name) + " are compressed by EXT_meshopt_compression, which cannot be changed in place");
    const std::size_t buffer = number(view, "buffer", {});
    element("buffers", buffer);
    const GltfFile::Buffer& source = file_.buffers[buffer];
    if (source.place == GltfFile::Buffer::Place::nowhere)
      fail(path_, "buffer " + std::to_string(buffer) + " cannot be used: " + source.problem);
    const std::size_t view_at = number(view, "byteOffset", 0), view_size = number(view, "byteLength", {});
    const std::size_t at = number(accessor, "byteOffset", 0), stride = number(view, "byteStride", size);
    const std::size_t count = number(accessor, "count", {});
    const bool is_in_buffer = view_at <= source.bytes.size() && view_size <= source.bytes.size() - view_at;
    if (!is_in_buffer || stride < size || at > view_size ||
        (count > 0 && (view_size - at < size || (count - 1) > (view_size - at - size) / stride)))
      refuse(std::string(name) + " go beyond the end of their buffer");
    return {buffer, view_at + at, stride, count};
  }

  GltfVectors vectors_of(std::size_t index, const char* name) const {
    const json& accessor = element("accessors", index);
    constexpr std::size_t type_float = 5126;
    if (text(accessor, "type") != "VEC3") refuse(std::string(name) + " are not of type VEC3");
    if (number(accessor, "componentType", {}) != type_float)
      refuse(std::string(name) + " are no floats (KHR_mesh_quantization), which cannot be changed in place");
    const Rows rows = rows_of(accessor, name, 3 * sizeof(float));
    return {index, rows.buffer, rows.offset, rows.stride, rows.count};
  }

  std::vector<std::uint32_t> indices_of(std::size_t index) const {
    const json& accessor = element("accessors", index);
    std::size_t size = 0;
    switch (number(accessor, "componentType", {})) {
      case 5121:
        size = 1;
        break;
      case 5123:
        size = 2;
        break;
      case 5125:
        size = 4;
        break;
      default:
        refuse("indices are no whole numbers of 8, 16 or 32 bits");
    }
    const Rows rows = rows_of(accessor, "indices", size);
    const std::string& bytes = file_.buffers[rows.buffer].bytes;
    std::vector<std::uint32_t> indices(rows.count);
    for (std::size_t i = 0; i < rows.count; ++i)
      for (std::size_t k = size; k-- > 0;)
        indices[i] = indices[i] << 8 | static_cast<unsigned char>(bytes[rows.offset + i * rows.stride + k]);
    return indices;
  }

  // Meshes.

  void read_primitive(const json& primitive, std::size_t mesh) {
    const json* const attributes = member(primitive, "attributes");
    if (!attributes || !has(*attributes, "POSITION")) return;
    const std::size_t mode = number(primitive, "mode", 4);
    if (mode < 4) {
      ++other_kinds_;
      return;
    }
    if (mode > 6) refuse("mode is " + std::to_string(mode) + "; allowed are 0 to 6");
    if (const json* const extensions = member(primitive, "extensions");
        extensions && has(*extensions, "KHR_draco_mesh_compression"))
      refuse("is compressed by KHR_draco_mesh_compression, which cannot be changed in place");
    if (has(primitive, "targets")) refuse("has morph targets, whose displacements would no longer fit");
    const std::size_t first = vertices_of(*attributes, mesh);
    const std::size_t count = mesh_.vertices[first].positions.count;
    std::vector<std::uint32_t> indices;
    if (has(primitive, "indices"))
      indices = indices_of(number(primitive, "indices", {}));
    else
      for (std::uint32_t i = 0; i < count; ++i) indices.push_back(i);
    for (std::size_t i = 0; i < indices.size(); ++i)
      if (indices[i] >= count)
        refuse("index " + std::to_string(i) + " is " + std::to_string(indices[i]) + "; there are " +
               std::to_string(count) + " positions");
    check_work(indices.size());
    add_triangles(indices, mode, first);
  }

  /// Which of the sets of vertices a primitive uses.
  std::size_t vertices_of(const json& attributes, std::size_t mesh) {
    const std::size_t accessor = number(attributes, "POSITION", {});
    const auto [known, is_new] = set_of_.try_emplace(accessor, mesh_.vertices.size());
    std::optional<GltfVectors> normals;
    if (has(attributes, "NORMAL")) normals = vectors_of(number(attributes, "NORMAL", {}), "normals");
    if (!is_new) {
      const GltfVertices& set = mesh_.vertices[known->second];
      if (normals && (!set.normals || set.normals->accessor != normals->accessor)) other_normals_[accessor] = true;
      return known->second;
    }
    GltfVertices set{vectors_of(accessor, "positions"), {}, {}, {}, true};
    if (normals && normals->count >= set.positions.count) set.normals = normals;
    set.to_world.SetIdentity();
    if (const auto transform = to_world_.find(mesh);
        transform != to_world_.end() && !(transform->second == set.to_world)) {
      set.to_world = transform->second;
      set.is_in_world = false;
      const double volume = set.to_world.Determinant();
      if (!std::isfinite(volume) || volume == 0) refuse("is made flat by its node's transform");
      set.from_world = vcg::Inverse(set.to_world);
    }
    const std::size_t total = vertices_ + set.positions.count;
    if (total > std::numeric_limits<std::int32_t>::max()) fail(path_, "has too many vertices");
    first_vertex_.push_back(static_cast<std::uint32_t>(vertices_));
    vertices_ = total;
    mesh_.vertices.push_back(set);
    return known->second;
  }

  /// A small file can use the same numbers again and again; no real one does so often.
  void check_work(std::size_t indices) {
    std::size_t bytes = 0;
    for (const auto& buffer : file_.buffers) bytes += buffer.bytes.size();
    indices_ += indices;
    constexpr std::size_t most_uses = 16;
    if (indices_ > most_uses * bytes) fail(path_, "uses the same vertices in too many primitives");
  }

  /// Turned over where the transform mirrors the mesh, so that they face outwards in the world.
  void add_triangles(const std::vector<std::uint32_t>& indices, std::size_t mode, std::size_t set) {
    const std::uint32_t first = first_vertex_[set];
    const bool is_mirrored = mesh_.vertices[set].to_world.Determinant() < 0;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (is_mirrored) std::swap(b, c);
      for (const std::size_t i : {a, b, c}) mesh_.corners.push_back(first + indices[i]);
    };
    if (mode == 4)
      for (std::size_t i = 2; i < indices.size(); i += 3) add(i - 2, i - 1, i);
    if (mode == 5)
      for (std::size_t i = 2; i < indices.size(); ++i) i % 2 == 0 ? add(i - 2, i - 1, i) : add(i - 1, i - 2, i);
    if (mode == 6)
      for (std::size_t i = 2; i < indices.size(); ++i) add(0, i - 1, i);
  }

  const GltfFile& file_;
  const fs::path& path_;
  GltfMesh mesh_;
  std::string where_;                          // for messages
  std::map<std::size_t, Matrix44d> to_world_;  // by mesh
  std::map<std::size_t, std::size_t> set_of_;  // of vertices, by accessor
  std::vector<std::uint32_t> first_vertex_;    // of each set
  std::size_t vertices_ = 0, indices_ = 0, other_kinds_ = 0;
  std::map<std::size_t, bool> other_normals_;
};

}  // namespace

GltfMesh find_gltf_mesh(const GltfFile& file, const fs::path& path) { return GltfReader(file, path).read(); }

}  // namespace mesh_tools::io
