// SPDX-License-Identifier: GPL-3.0-or-later
#include "scratch_folder.h"

#include <random>
#include <string>
#include <system_error>

#include <durable_files/replace_file.h>

#include "fail.h"

namespace tiles {
namespace fs = std::filesystem;
ScratchFolder::ScratchFolder(const fs::path& place) {
  std::error_code error;
  place_ = fs::absolute(place);
  if (!place_.has_filename()) place_ = place_.parent_path();  // of "folder/"
  if (fs::exists(place_, error) && !(fs::is_directory(place_, error) && fs::is_empty(place_, error)))
    fail(place, "is there already, and not empty");
  std::random_device random;
  bool made = false;
  do {
    path_ = place_.parent_path() / ("." + place_.filename().string() + "." + std::to_string(random()) + ".part");
    made = fs::create_directory(path_, error);
  } while (!made && !error);  // there is one already
  if (made) return;
  path_.clear();
  fail(place, "cannot be made: " + error.message());
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
}

void ScratchFolder::put_in_place() {
  std::error_code error;
  fs::rename(path_, place_, error);
  if (error) fail(place_, "cannot be made: " + error.message());
  path_.clear();
  durable_files::flush_folder(place_.parent_path());
}

}  // namespace tiles
