// Geomview's OFF, with the prefixes N (normals) and C (colours).

#include <cmath>

#include <vcg/complex/algorithms/update/bounding.h>

#include "formats.h"
#include "off_header.h"
#include "text.h"

namespace mesh_tools::io {
namespace {

using Words = std::vector<std::string_view>;
using Allocator = vcg::tri::Allocator<Mesh>;

/// 3 or 4 components, whole numbers 0..255 or fractions 0..1.
vcg::Color4b read_color(const LineReader& reader, const Words& words, std::size_t first) {
  bool fractions = false;
  for (std::size_t i = first; i < words.size(); ++i) fractions |= words[i].find('.') != std::string_view::npos;
  vcg::Color4b color(255, 255, 255, 255);
  for (std::size_t i = first; i < words.size(); ++i) {
    const double value = reader.number(words[i]) * (fractions ? 255 : 1);
    if (!(value >= 0 && value <= 255)) reader.fail("'" + printable(words[i]) + "' is not a colour component");
    color[static_cast<int>(i - first)] = static_cast<unsigned char>(std::lround(value));
  }
  return color;
}

bool is_color(std::size_t words) { return words == 3 || words == 4; }

}  // namespace

MeshFile read_off(const std::string& text, const std::filesystem::path& path) {
  LineReader reader(text, path);
  const OffHeader header = read_off_header(reader);
  // A vertex takes at least six bytes ("0 0 0" and a line's end) and a face eight, so that wrong counts cannot ask for
  // more memory than the file's size explains.
  const std::int64_t size = static_cast<std::int64_t>(text.size()) + 1;  // the last line's end may be missing
  if (header.vertices > size / 6 || header.faces > size / 8)
    reader.fail("the counts of vertices and faces exceed the file");
  MeshFile file;
  Mesh& mesh = file.mesh;
  if (header.normals) file.attributes |= vertex_normal;
  if (header.vertices > 0) Allocator::AddVertices(mesh, header.vertices);
  Words words;
  const std::size_t fixed = 3 + (header.normals ? 3 : 0), texture = header.texture ? 2 : 0;
  for (auto& vertex : mesh.vert) {
    if (!reader.next(words)) reader.fail("the file ends before its " + std::to_string(header.vertices) + " vertices");
    if (words.size() < fixed + texture) reader.fail("a vertex has too few numbers");
    for (int k = 0; k < 3; ++k) {
      vertex.P()[k] = reader.number(words[k]);
      if (header.normals) vertex.N()[k] = reader.number(words[3 + k]);
    }
    words.resize(words.size() - texture);
    if (header.colors && is_color(words.size() - fixed)) {
      vertex.C() = read_color(reader, words, fixed);
      file.attributes |= vertex_color;
    }
  }
  std::size_t polygons = 0;
  for (std::int64_t f = 0; f < header.faces; ++f) {
    if (!reader.next(words)) reader.fail("the file ends before its " + std::to_string(header.faces) + " faces");
    const std::int64_t corners = reader.integer(words[0]);
    if (corners < 3) reader.fail("a face has " + std::to_string(corners) + " corners; at least 3 are needed");
    const std::size_t end = static_cast<std::size_t>(corners) + 1;
    if (words.size() < end) reader.fail("a face has fewer vertices than it says");
    std::vector<std::int64_t> index;
    for (std::size_t k = 1; k < end; ++k) {
      index.push_back(reader.integer(words[k]));
      if (index.back() < 0 || index.back() >= header.vertices)
        reader.fail("a face refers to vertex " + printable(words[k]) + "; allowed are 0 to " +
                    std::to_string(header.vertices - 1));
    }
    const bool colored = is_color(words.size() - end);
    const vcg::Color4b color = colored ? read_color(reader, words, end) : vcg::Color4b(255, 255, 255, 255);
    if (colored) file.attributes |= face_color;
    if (index.size() > 3) ++polygons;
    for (std::size_t k = 2; k < index.size(); ++k) {
      // Not by Allocator::AddFace, which aborts on a repeated vertex where assertions are on.
      detail::FaceD& face = mesh.face.emplace_back();
      ++mesh.fn;
      face.V(0) = &mesh.vert[static_cast<std::size_t>(index[0])];
      face.V(1) = &mesh.vert[static_cast<std::size_t>(index[k - 1])];
      face.V(2) = &mesh.vert[static_cast<std::size_t>(index[k])];
      face.C() = color;
    }
  }
  if (header.texture) file.not_kept.push_back(path.string() + ": texture coordinates are not kept");
  note_polygons(polygons, path, file);
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
  return file;
}

namespace {

/// Scalar is what positions and normals are rounded to.
template <class Scalar>
std::string off_text(const Mesh& mesh, int attributes) {
  const bool normals = attributes & vertex_normal, colors = attributes & vertex_color;
  const bool face_colors = attributes & face_color;
  std::string text = std::string(colors ? "C" : "") + (normals ? "N" : "") + "OFF\n" + std::to_string(mesh.vn) + " " +
                     std::to_string(mesh.fn) + " 0\n";
  std::vector<std::size_t> number(mesh.vert.size());
  std::size_t count = 0;
  const auto append_color = [&](const vcg::Color4b& color) {
    for (int k = 0; k < 4; ++k) text.append(" ").append(std::to_string(color[k]));
  };
  const auto append_point = [&](const auto& p) {
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text += ' ';
      append_number(text, static_cast<Scalar>(p[k]));
    }
  };
  for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
    const auto& vertex = mesh.vert[i];
    if (vertex.IsD()) continue;
    number[i] = count++;
    append_point(vertex.cP());
    if (normals) append_point((text += ' ', vertex.cN()));
    if (colors) append_color(vertex.cC());
    text += '\n';
  }
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    text += '3';
    for (int k = 0; k < 3; ++k) text.append(" ").append(std::to_string(number[vcg::tri::Index(mesh, face.cV(k))]));
    if (face_colors) append_color(face.cC());
    text += '\n';
  }
  return text;
}

}  // namespace

std::string off_bytes(const MeshFile& file) {
  return file.precision == Precision::double_precision ? off_text<double>(file.mesh, file.attributes)
                                                       : off_text<float>(file.mesh, file.attributes);
}

}  // namespace mesh_tools::io
