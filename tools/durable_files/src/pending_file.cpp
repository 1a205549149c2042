// SPDX-License-Identifier: GPL-3.0-or-later
#include <durable_files/pending_file.h>

#include <random>
#include <string>
#include <utility>

#include "system.h"

namespace durable_files {
namespace fs = std::filesystem;
namespace {

constexpr const char* cannot_be_written = "cannot be written";
constexpr const char* not_to_its_end = "could not be written to its end";

/// A hidden name beside `target` that nobody can guess.
fs::path unpredictable_name(const fs::path& target) {
  // The whole must not be longer than a name may be, which `target` may be already.
  constexpr std::size_t longest_stem = 200;
  constexpr char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> any(0, sizeof letters - 2);
  std::string name = "." + target.filename().string().substr(0, longest_stem) + ".";
  for (int i = 0; i < 12; ++i) name += letters[any(random)];
  return target.parent_path() / (name + ".part");
}

}  // namespace

PendingFile::PendingFile(const fs::path& path) : path_(path), target_(final_target(path)) {
  std::error_code error;
  do {
    pending_ = unpredictable_name(target_);
    file_ = system::create(pending_, target_, error);
  } while (error == std::errc::file_exists);
  if (error) {
    pending_.clear();
    fail(cannot_be_written, error);
  }
}

PendingFile::~PendingFile() {
  std::error_code ignored;
  if (file_ >= 0) ignored = system::close(file_);
  if (!pending_.empty()) fs::remove(pending_, ignored);
}

void PendingFile::write(std::string_view bytes) {
  if (const std::error_code error = system::write(file_, bytes)) fail(not_to_its_end, error);
}

void PendingFile::complete() {
  if (const std::error_code error = system::flush(file_)) fail(not_to_its_end, error);
  if (const std::error_code error = system::close(std::exchange(file_, -1))) fail(not_to_its_end, error);
}

void PendingFile::put_in_place() {
  if (const std::error_code error = system::rename(pending_, target_)) fail(cannot_be_written, error);
  pending_.clear();
  flush_folder(target_.parent_path());
}

void PendingFile::fail(const char* what, const std::error_code& error) const {
  throw WriteError(path_.string() + ": " + what + ": " + error.message());
}

}  // namespace durable_files
