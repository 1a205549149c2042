// SPDX-License-Identifier: GPL-3.0-or-later
#include <system_error>

#include <mesh_tools/mesh_io.h>

#include "formats.h"
#include "large_pages.h"

namespace mesh_tools {
namespace {

/// What `function` gives, its errors as this library's.
template <class Function>
auto as_file_error(const std::filesystem::path& path, const Function& function) {
  try {
    return function();
  } catch (const std::system_error& error) {
    io::fail(path, "cannot be read: " + error.code().message());
  }
}

}  // namespace

SourceFile::SourceFile(const std::filesystem::path& path)
    : file_(as_file_error(path, [&] { return durable_files::InputFile(path); })) {
  if (!file_.state().is_regular) io::fail(path, "cannot be read: it is not a regular file");
}

std::string SourceFile::read() const {
  std::string bytes;
  io::reserve_in_large_pages(bytes, size());
  bytes.resize(size());
  read(0, bytes.data(), bytes.size());
  return bytes;
}

void SourceFile::read(std::size_t offset, char* bytes, std::size_t count) const {
  const auto got = as_file_error(path(), [&] { return file_.read(offset, bytes, count); });
  if (got != count) io::fail(path(), "could not be read to its end");
}

bool SourceFile::has_changed() const {
  return as_file_error(path(), [&] { return file_.state_now(); }) != file_.state();
}

}  // namespace mesh_tools
