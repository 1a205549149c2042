// SPDX-License-Identifier: GPL-3.0-or-later
#include <durable_files/input_file.h>

#include <system_error>
#include <utility>

#include "system.h"

namespace durable_files {
namespace {

std::shared_ptr<const int> open(const std::filesystem::path& path) {
  std::error_code error;
  const int file = system::open(path, error);
  if (error) throw std::system_error(error);
  return {new int(file), [](const int* opened) {
            (void)system::close(*opened);
            delete opened;
          }};
}

}  // namespace

InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)) {
  kept_open_ = open(path_);
  state_ = state_now();
  if (!system::replaces_open_files) kept_open_.reset();
}

InputFile::State InputFile::state_now() const {
  std::error_code error;
  const State state = system::state_of(kept_open_ ? *kept_open_ : *open(path_), error);
  if (error) throw std::system_error(error);
  return state;
}

std::size_t InputFile::read(std::uint64_t offset, void* bytes, std::size_t count) const {
  const std::shared_ptr<const int> file = kept_open_ ? kept_open_ : open(path_);
  std::size_t done = 0;
  while (done < count) {
    std::error_code error;
    const std::size_t got = system::read(*file, offset + done, static_cast<char*>(bytes) + done, count - done, error);
    if (error) throw std::system_error(error);
    if (got == 0) break;
    done += got;
  }
  return done;
}

}  // namespace durable_files
