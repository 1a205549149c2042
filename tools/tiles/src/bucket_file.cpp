// SPDX-License-Identifier: GPL-3.0-or-later
#include "bucket_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <string>

#include "bucket_writer.h"
#include "fail.h"
#include "index_set.h"

namespace tiles {
namespace {

constexpr std::uint64_t magic = 0x31746b6275636b74;  // changes with the layout
struct Header {
  std::uint64_t magic_number, cells;
};

std::vector<char> all_bytes(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return {};  // no record at all
  const InputFile file(path);
  std::vector<char> bytes(static_cast<std::size_t>(file.size()));
  file.read(0, bytes.data(), bytes.size());
  return bytes;
}

Point point_at(const char* raw, std::size_t real_size) {
  Point p;
  for (std::size_t k = 0; k < 3; ++k) {
    float narrow = 0;
    std::memcpy(real_size == 4 ? static_cast<void*>(&narrow) : &p[k], raw + k * real_size, real_size);
    if (real_size == 4) p[k] = static_cast<double>(narrow);
  }
  return p;
}

template <class T>
void append(const std::filesystem::path& path, const std::vector<T>& values) {
  append_to_file(path, values.data(), values.size() * sizeof(T));
}

}  // namespace

BucketFile::BucketFile(const std::filesystem::path& path, std::size_t real_size) : file_(path), real_size_(real_size) {
  Header header{};
  file_.read(0, &header, sizeof header);
  if (header.magic_number != magic || header.cells > file_.size() / sizeof(Cell))
    fail(path, "is damaged; make the plan again");
  cell_.resize(static_cast<std::size_t>(header.cells));
  file_.read(sizeof header, cell_.data(), cell_.size() * sizeof(Cell));
  vertex_begin_.push_back(0);
  face_begin_.push_back(0);
  for (const Cell& cell : cell_) {
    vertex_begin_.push_back(vertex_begin_.back() + cell.vertices);
    face_begin_.push_back(face_begin_.back() + cell.faces);
  }
  data_begin_ = sizeof header + cell_.size() * sizeof(Cell);
  const std::uint64_t end = data_begin_ + vertex_begin_.back() * (sizeof(std::uint32_t) + 3 * real_size_) +
                            face_begin_.back() * sizeof(BucketFace);
  if (end != file_.size()) fail(path, "is cut off; make the plan again");
}

void BucketFile::read(std::size_t begin, std::size_t end, BucketPart& part) const {
  const std::uint64_t positions = data_begin_ + vertex_begin_.back() * sizeof(std::uint32_t);
  const std::uint64_t faces = positions + vertex_begin_.back() * 3 * real_size_;
  const auto append_range = [&](std::uint64_t from, std::uint64_t first, std::uint64_t last, std::size_t size,
                                auto& values) {
    const std::size_t before = values.size(), count = static_cast<std::size_t>(last - first) * size;
    values.resize(before + count / sizeof values[0]);
    if (count > 0) file_.read(from + first * size, values.data() + before, count);
  };
  append_range(data_begin_, vertex_begin_[begin], vertex_begin_[end], sizeof(std::uint32_t), part.vertex);
  append_range(positions, vertex_begin_[begin], vertex_begin_[end], 3 * real_size_, part.position);
  append_range(faces, face_begin_[begin], face_begin_[end], sizeof(BucketFace), part.face);
}

void BucketFile::make(const std::filesystem::path& path, const std::filesystem::path& vertices,
                      const std::filesystem::path& faces, std::size_t real_size, const Grid& grid) {
  const std::size_t record = sizeof(std::uint32_t) + 3 * real_size;
  std::vector<char> raw = all_bytes(vertices);
  const std::size_t count = raw.size() / record;
  std::vector<std::uint32_t> vertex(count), cell_of(count);  // as they come, which is ascending
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(&vertex[i], raw.data() + i * record, sizeof vertex[i]);
    cell_of[i] = grid.cell_of(point_at(raw.data() + i * record + sizeof vertex[i], real_size));
  }
  std::map<std::uint32_t, Cell> cells;
  for (const std::uint32_t number : cell_of) ++cells.try_emplace(number, Cell{number, 0, 0}).first->second.vertices;
  std::vector<Cell> cell;
  cell.reserve(cells.size());
  for (const auto& [number, entry] : cells) cell.push_back(entry);
  const auto place_of_cell = [&](std::uint32_t number) {
    const auto found =
        std::lower_bound(cell.begin(), cell.end(), number, [](const Cell& a, std::uint32_t b) { return a.number < b; });
    return static_cast<std::uint32_t>(found - cell.begin());
  };
  for (std::uint32_t& number : cell_of) number = place_of_cell(number);

  append(path, std::vector<Header>{{magic, cell.size()}});
  std::vector<std::uint32_t> next(cell.size() + 1, 0);
  for (const std::uint32_t place : cell_of) ++next[place + 1];
  for (std::size_t c = 0; c < cell.size(); ++c) next[c + 1] += next[c];
  std::vector<std::uint32_t> sorted_vertex(count);
  std::vector<char> sorted_position(count * 3 * real_size);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t to = next[cell_of[i]]++;
    sorted_vertex[to] = vertex[i];
    std::memcpy(sorted_position.data() + to * 3 * real_size, raw.data() + i * record + sizeof vertex[i], 3 * real_size);
  }
  std::vector<char>().swap(raw);

  // Each face once for each of its cells here.
  IndexSet own(vertex.empty() ? 0 : std::size_t{vertex.back()} + 1);
  for (const std::uint32_t v : vertex) own.add(v);
  own.count();
  raw = all_bytes(faces);
  const auto for_each_cell = [&](const BucketFace& face, const auto& visit) {
    std::array<std::uint32_t, 3> seen{};
    std::size_t different = 0;
    for (const std::uint32_t v : face.vertex) {
      if (vertex.empty() || v > vertex.back() || !own.contains(v)) continue;
      const std::uint32_t place = cell_of[own.rank(v)];
      if (std::find(seen.begin(), seen.begin() + different, place) != seen.begin() + different) continue;
      seen[different++] = place;
      visit(place);
    }
  };
  const std::size_t face_count = raw.size() / sizeof(BucketFace);
  const auto face_at = [&](std::size_t i) {
    BucketFace face;
    std::memcpy(&face, raw.data() + i * sizeof face, sizeof face);
    return face;
  };
  for (std::size_t i = 0; i < face_count; ++i)
    for_each_cell(face_at(i), [&](std::uint32_t place) { ++cell[place].faces; });
  next.assign(cell.size() + 1, 0);
  for (std::size_t c = 0; c < cell.size(); ++c) next[c + 1] = next[c] + cell[c].faces;
  std::vector<BucketFace> sorted_face(next.back());
  for (std::size_t i = 0; i < face_count; ++i)
    for_each_cell(face_at(i), [&](std::uint32_t place) { sorted_face[next[place]++] = face_at(i); });

  append(path, cell);
  append(path, sorted_vertex);
  append(path, sorted_position);
  append(path, sorted_face);
  std::filesystem::remove(vertices);
  std::filesystem::remove(faces);
}

}  // namespace tiles
