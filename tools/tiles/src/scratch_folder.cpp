// SPDX-License-Identifier: GPL-3.0-or-later
#include "scratch_folder.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
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
  int made = 0;
  do {
    path_ = place_.parent_path() / ("." + place_.filename().string() + "." + std::to_string(random()) + ".part");
    made = ::mkdir(path_.c_str(), 0777);
  } while (made != 0 && errno == EEXIST);
  if (made == 0) return;
  const std::string reason = std::strerror(errno);
  path_.clear();
  fail(place, "cannot be made: " + reason);
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
}

void ScratchFolder::put_in_place() {
  if (std::rename(path_.c_str(), place_.c_str()) != 0)
    fail(place_, std::string("cannot be made: ") + std::strerror(errno));
  path_.clear();
  durable_files::flush_folder(place_.parent_path());
}

}  // namespace tiles
