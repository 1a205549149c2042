// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_file.h"

#include "../formats.h"
#include "../text.h"
#include "base64.h"

namespace mesh_tools::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Buffer = GltfFile::Buffer;

/// The content of a chunk and where it begins.
struct Chunk {
  std::string_view type, content;
  std::size_t at;
};

std::vector<Chunk> chunks_of(std::string_view bytes, const fs::path& path) {
  constexpr std::size_t header = 12, chunk_header = 8;
  if (bytes.size() < header) fail(path, "is cut off: a GLB file has a header of 12 bytes");
  const auto number = [&](std::size_t at) { return number_at<std::uint32_t>(bytes.data() + at); };
  if (number(4) != 2) fail(path, "is GLB of version " + std::to_string(number(4)) + "; 2 is supported");
  const std::size_t length = number(8);
  if (length > bytes.size()) fail(path, "is cut off: it says that it has " + std::to_string(length) + " bytes");
  std::vector<Chunk> chunks;
  for (std::size_t at = header; at + chunk_header <= length;) {
    const std::size_t size = number(at);
    if (size > length - at - chunk_header) fail(path, "has a chunk that goes beyond its end");
    chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + chunk_header, size), at + chunk_header});
    at += chunk_header + size;
  }
  return chunks;
}

Buffer open_buffer(const std::string& uri, const fs::path& path) {
  Buffer buffer;
  if (uri.compare(0, 5, "data:") == 0) {
    constexpr std::string_view mark = ";base64,";
    const std::size_t at = uri.find(mark);
    auto bytes = at == uri.npos ? std::nullopt : from_base64(std::string_view(uri).substr(at + mark.size()));
    if (!bytes) {
      buffer.problem = "is a data URI without sound base64";
      return buffer;
    }
    buffer.place = Buffer::Place::data_uri;
    buffer.data_prefix = uri.substr(0, at + mark.size());
    buffer.bytes = std::move(*bytes);
    return buffer;
  }
  if (uri.find("://") != uri.npos) {
    buffer.problem = "is at " + printable(uri) + "; only files beside this one are read";
    return buffer;
  }
  buffer.name = without_escapes(uri);
  try {
    buffer.bytes = SourceFile(path.parent_path() / buffer.name).read();
    buffer.place = Buffer::Place::file;
  } catch (const FileError& error) {
    buffer.problem = error.what();
  }
  return buffer;
}

}  // namespace

std::string without_escapes(std::string_view uri) {
  std::string text;
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_escape = uri[i] == '%' && i + 2 < uri.size() &&
                           uri.substr(i + 1, 2).find_first_not_of("0123456789abcdefABCDEF") == uri.npos;
    text += is_escape ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
    if (is_escape) i += 2;
  }
  return text;
}

GltfFile open_gltf(const std::string& bytes, const fs::path& path) {
  GltfFile file;
  file.is_glb = bytes.compare(0, 4, "glTF") == 0;
  std::optional<Chunk> binary;
  if (file.is_glb) {
    for (const Chunk& chunk : chunks_of(bytes, path)) {
      if (chunk.type == "JSON" && file.text.empty()) file.text = chunk.content;
      if (chunk.type == std::string_view("BIN\0", 4) && !binary) binary = chunk;
    }
  } else {
    file.text = std::string_view(bytes).substr(byte_order_mark(bytes));
  }
  file.json = std::make_shared<const json>(json::parse(file.text, nullptr, false));
  if (!file.json->is_object()) fail(path, "holds no sound JSON, as a glTF file does");
  const json* const buffers = file.json->contains("buffers") ? &(*file.json)["buffers"] : nullptr;
  for (std::size_t i = 0; buffers && buffers->is_array() && i < buffers->size(); ++i) {
    const json& declared = (*buffers)[i];
    if (declared.is_object() && declared.contains("uri") && declared["uri"].is_string()) {
      file.buffers.push_back(open_buffer(declared["uri"].get<std::string>(), path));
    } else if (i == 0 && binary) {
      file.buffers.push_back({Buffer::Place::chunk, std::string(binary->content), binary->at, {}, {}, {}});
    } else {
      file.buffers.emplace_back().problem = "has no uri";
    }
  }
  return file;
}

}  // namespace mesh_tools::io
