// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <system_error>
#include <utility>

#include "../file_names.h"
#include "../formats.h"
#include "../splice/moved_normals.h"
#include "../splice/splice.h"
#include "../splice/text_splicer.h"
#include "base64.h"
#include "gltf_file.h"
#include "gltf_vertices.h"
#include "json_places.h"

namespace mesh_tools::io {
namespace {

namespace fs = std::filesystem;
using vcg::Point3d;
using vcg::Point3f;
using Place = GltfFile::Buffer::Place;

std::string with_escapes(const std::string& name) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string uri;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= ' ' || std::string_view("%\"#?\\<>^`{|}").find(c) != std::string_view::npos)
      uri.append("%").append(1, digits[byte >> 4]).append(1, digits[byte & 15]);
    else
      uri += c;
  }
  return uri;
}

class GltfSplicer {
 public:
  GltfSplicer(std::string& bytes, const SpliceInput& input, const fs::path& out)
      : bytes_(bytes),
        input_(input),
        out_(out),
        file_(open_gltf(bytes, input.path)),
        found_(find_gltf_mesh(file_, input.path)),
        is_changed_(file_.buffers.size(), false) {
    std::error_code error;
    is_same_file_ = fs::equivalent(input.path, out, error) && !error;
  }

  SplicedFiles splice() {
    const FlatMesh& mesh = input_.file.mesh;
    std::size_t count = 0;
    for (const GltfVertices& set : found_.vertices) count += set.positions.count;
    check_same_count(input_.path, "vertices", mesh.vertices(), count);
    find_moved();
    put_vertices();
    visit_elements(json_member(file_.text, "accessors"),
                   [&](std::size_t index, std::string_view accessor) { put_bounds(index, accessor); });
    visit_elements(json_member(file_.text, "buffers"), [&](std::size_t index, std::string_view buffer) {
      if (index < file_.buffers.size()) put_buffer(index, json_member(buffer, "uri"));
    });
    visit_elements(json_member(file_.text, "images"), [&](std::size_t index, std::string_view image) {
      put_image_name(index, json_member(image, "uri"));
    });
    put_text();
    result_.mesh = std::move(bytes_);
    return std::move(result_);
  }

 private:
  void find_moved() {
    std::size_t v = 0;
    for (const GltfVertices& set : found_.vertices)
      for (std::size_t i = 0; i < set.positions.count; ++i, ++v) {
        vertices_.add(place_of(file_, set, i), input_.file.mesh.position[v]);
        normals_.push_back(set.normals ? normal_of(file_, set, i) : Point3d(0, 0, 0));
      }
  }

  void put_vertices() {
    const FlatMesh& mesh = input_.file.mesh;
    MovedNormals moved_normals(mesh, vertices_, normals_);
    moved_normals.add_triangles();
    moved_normals.finish();
    std::size_t v = 0;
    for (const GltfVertices& set : found_.vertices)
      for (std::size_t i = 0; i < set.positions.count; ++i, ++v) {
        if (vertices_.moved[v]) put(set.positions, i, as_stored(set, mesh.position[v]));
        const auto normal = set.normals ? moved_normals.normal(v) : std::nullopt;
        if (normal) put(*set.normals, i, normal_as_stored(set, *normal));
      }
  }

  /// Numbers that are the same keep their bytes: 0 and -0 have others.
  void put(const GltfVectors& vectors, std::size_t index, Point3f now) {
    const Point3f before = vector_at(file_, vectors, index);
    for (int k = 0; k < 3; ++k)
      if (is_same_number(before[k], now[k])) now[k] = before[k];
    if (before == now) return;
    set_vector(file_, vectors, index, now);
    is_changed_[vectors.buffer] = true;
  }

  /// The least and the largest coordinates of positions.
  void put_bounds(std::size_t index, std::string_view accessor) {
    const auto set = std::find_if(found_.vertices.begin(), found_.vertices.end(),
                                  [&](const GltfVertices& vertices) { return vertices.positions.accessor == index; });
    if (set == found_.vertices.end() || !is_changed_[set->positions.buffer] || set->positions.count == 0) return;
    Point3f least = vector_at(file_, set->positions, 0), largest = least;
    for (std::size_t i = 1; i < set->positions.count; ++i) {
      const Point3f place = vector_at(file_, set->positions, i);
      for (int k = 0; k < 3; ++k) {
        least[k] = std::min(least[k], place[k]);
        largest[k] = std::max(largest[k], place[k]);
      }
    }
    const auto put_numbers = [&](std::string_view array, const Point3f& now) {
      visit_elements(array, [&](std::size_t k, std::string_view word) {
        float before = 0;
        std::from_chars(word.data(), word.data() + word.size(), before);
        const float number = k < 3 ? now[static_cast<int>(k)] : before;
        if (before == number || !std::isfinite(number)) return;  // JSON knows finite numbers only
        char digits[64];
        replace(word, {digits, std::to_chars(digits, digits + sizeof digits, number).ptr});
      });
    };
    put_numbers(json_member(accessor, "min"), least);
    put_numbers(json_member(accessor, "max"), largest);
  }

  void put_buffer(std::size_t index, std::string_view uri) {
    GltfFile::Buffer& buffer = file_.buffers[index];
    if (buffer.place == Place::file) return put_buffer_file(buffer, is_changed_[index], index, uri);
    if (!is_changed_[index]) return;
    if (buffer.place == Place::chunk)
      bytes_.replace(buffer.chunk_at, buffer.bytes.size(), buffer.bytes);
    else
      replace(uri, nlohmann::json(buffer.data_prefix + to_base64(buffer.bytes)).dump());
  }

  /// A file that changes gets a name after OUT, lest others that use it change too; but where the result takes the
  /// place of its input, so does this. One that does not change stays where it is.
  void put_buffer_file(GltfFile::Buffer& buffer, bool is_changed, std::size_t index, std::string_view uri) {
    if (!is_changed) return put_name(uri, buffer.name.string());
    const bool leads_out = buffer.name.is_absolute() || *buffer.name.lexically_normal().begin() == "..";
    fs::path place = input_.path.parent_path() / buffer.name;
    if (!is_same_file_ || leads_out) {
      place = out_;
      place += (index == 0 ? "" : "." + std::to_string(index)) + ".bin";
      replace(uri, nlohmann::json(with_escapes(place.filename().string())).dump());
    }
    result_.beside.push_back({place, std::move(buffer.bytes)});
  }

  void put_image_name(std::size_t index, std::string_view uri) {
    const auto& image = (*file_.json)["images"][index];
    if (uri.empty() || !image["uri"].is_string()) return;
    const auto text = image["uri"].get<std::string>();
    if (text.compare(0, 5, "data:") != 0 && text.find("://") == text.npos) put_name(uri, without_escapes(text));
  }

  /// The name of a file that stays where it is.
  void put_name(std::string_view uri, const std::string& name) {
    const std::string moved = moved_file_name(name, input_.path.parent_path(), out_.parent_path());
    if (moved != name) replace(uri, nlohmann::json(with_escapes(moved)).dump());
  }

  void replace(std::string_view part, const std::string& by) { changes_[part.data()] = {part, by}; }

  /// The JSON comes before the buffer in GLB, and its size is a multiple of four there.
  void put_text() {
    if (changes_.empty()) return;
    std::string text;
    const Write append = [&text](std::string_view part) { text += part; };
    TextSplicer splicer(file_.text, append);
    for (const auto& [at, change] : changes_) splicer.replace(change.first, change.second);
    splicer.finish();
    if (file_.is_glb) text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto at = static_cast<std::size_t>(file_.text.data() - bytes_.data());
    const std::size_t before = file_.text.size();
    bytes_.replace(at, before, text);
    if (!file_.is_glb) return;
    put_number(bytes_.data() + at - 8, static_cast<std::uint32_t>(text.size()));
    char* const size = bytes_.data() + 8;  // of the whole file
    put_number(size, number_at<std::uint32_t>(size) + static_cast<std::uint32_t>(text.size() - before));
  }

  std::string& bytes_;
  const SpliceInput& input_;
  const fs::path& out_;
  GltfFile file_;
  GltfMesh found_;
  MovedVertices vertices_;
  std::vector<Point3d> normals_;
  std::vector<bool> is_changed_;  // of each buffer
  bool is_same_file_ = false;
  std::map<const char*, std::pair<std::string_view, std::string>> changes_;  // of the JSON, by place
  SplicedFiles result_;
};

}  // namespace

SplicedFiles splice_gltf(std::string bytes, const SpliceInput& input, const fs::path& out) {
  return GltfSplicer(bytes, input, out).splice();
}

}  // namespace mesh_tools::io
