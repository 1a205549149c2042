// SPDX-License-Identifier: GPL-3.0-or-later
#include <durable_files/pending_file.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <string>

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using durable_files::final_target;
using durable_files::PendingFile;
using durable_files::replace_file;
using durable_files::WriteError;

class PendingFiles : public tools_tests::TemporaryFolder {
 protected:
  static void put(const fs::path& path, const std::string& text) {
    PendingFile file(path);
    file.write(text);
    file.complete();
    file.put_in_place();
  }
  static mode_t mode(const fs::path& path) {
    struct stat status = {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 07777;
  }
};

/// Sets the umask, and back again.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(::umask(mask)) {}
  ~Umask() { ::umask(before_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t before_;
};

TEST_F(PendingFiles, appear_when_they_are_put_in_place_and_not_before) {
  {
    PendingFile file(path("a"));
    file.write("half");
    file.write(" and half");
    EXPECT_FALSE(fs::exists(path("a")));
    file.complete();
    EXPECT_FALSE(fs::exists(path("a")));
    file.put_in_place();
  }
  EXPECT_EQ(bytes_of(path("a")), "half and half");
  EXPECT_EQ(files(), 1u);
}

TEST_F(PendingFiles, that_are_given_up_leave_nothing) {
  write("a", "precious");
  { PendingFile(path("a")).write("something else"); }
  EXPECT_EQ(bytes_of(path("a")), "precious");
  EXPECT_EQ(files(), 1u);
}

/// As two processes of one number in two containers that share a volume.
TEST_F(PendingFiles, of_two_writers_never_mix) {
  PendingFile first(path("a")), second(path("a"));
  EXPECT_EQ(files(), 2u) << "two names";
  first.write("first, long");
  second.write("second");
  first.complete();
  second.complete();
  first.put_in_place();
  EXPECT_EQ(bytes_of(path("a")), "first, long");
  second.put_in_place();
  EXPECT_EQ(bytes_of(path("a")), "second");
  EXPECT_EQ(files(), 1u);
}

TEST_F(PendingFiles, get_the_permissions_that_the_umask_gives_to_new_files) {
  for (const auto& [mask, expected] : {std::pair<mode_t, mode_t>{022, 0644}, {077, 0600}, {0, 0666}}) {
    const Umask scope(mask);
    const fs::path file = path(std::to_string(mask));
    put(file, "x");
    EXPECT_EQ(mode(file), expected);
  }
}

TEST_F(PendingFiles, have_the_permissions_of_what_they_replace_from_the_beginning) {
  for (const mode_t old : {0600, 0666, 0640}) {
    const auto file = write("a", "old");
    ASSERT_EQ(::chmod(file.c_str(), old), 0);
    const Umask scope(022);
    PendingFile pending(file);
    for (const auto& entry : fs::directory_iterator(folder_)) EXPECT_EQ(mode(entry.path()), old) << entry.path();
    pending.complete();
    pending.put_in_place();
    EXPECT_EQ(mode(file), old);
  }
}

TEST_F(PendingFiles, go_to_where_a_link_leads) {
  fs::create_directory(path("deep"));
  write("deep/old", "old");
  fs::create_symlink("deep/old", path("link"));
  fs::create_symlink("link", path("link_to_link"));
  fs::create_symlink("deep/none", path("dangling"));
  fs::create_symlink(path("deep/far"), path("absolute"));
  put(path("link_to_link"), "new");
  put(path("dangling"), "made");
  put(path("absolute"), "far");
  for (const char* name : {"link", "link_to_link", "dangling", "absolute"}) EXPECT_TRUE(fs::is_symlink(path(name)));
  EXPECT_EQ(bytes_of(path("deep/old")), "new");
  EXPECT_EQ(bytes_of(path("deep/none")), "made");
  EXPECT_EQ(bytes_of(path("deep/far")), "far");
}

TEST_F(PendingFiles, refuse_links_that_lead_nowhere) {
  fs::create_symlink("b", path("a"));
  fs::create_symlink("a", path("b"));
  EXPECT_THROW(final_target(path("a")), WriteError);
  EXPECT_THROW(PendingFile{path("a")}, WriteError);
  fs::create_symlink("no_folder/x", path("c"));
  EXPECT_EQ(final_target(path("c")), path("no_folder/x"));
  EXPECT_THROW(PendingFile{path("c")}, WriteError);
}

TEST_F(PendingFiles, may_have_names_as_long_as_the_system_allows) {
  const fs::path longest = path(std::string(255, 'x'));
  put(longest, "long");
  EXPECT_EQ(bytes_of(longest), "long");
  EXPECT_THROW(PendingFile{path(std::string(256, 'x'))}, WriteError);
  EXPECT_EQ(files(), 1u);
}

/// As on a full disk: the system takes no more bytes.
TEST_F(PendingFiles, that_cannot_be_written_to_their_end_say_so) {
  write("a", "precious");
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {100, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string what;
  try {
    put(path("a"), std::string(1000, 'x'));
  } catch (const WriteError& error) {
    what = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(what, path("a").string() + ": could not be written to its end: File too large");
  EXPECT_EQ(bytes_of(path("a")), "precious");
  EXPECT_EQ(files(), 1u);
}

TEST_F(PendingFiles, replace_file_moves_and_keeps_permissions) {
  const auto from = write("from", "new"), to = write("to", "old");
  ASSERT_EQ(::chmod(to.c_str(), 0640), 0);
  replace_file(from, to);
  EXPECT_EQ(bytes_of(to), "new");
  EXPECT_EQ(mode(to), 0640u);
  EXPECT_EQ(files(), 1u);
  EXPECT_THROW(replace_file(from, to), WriteError);
  EXPECT_EQ(bytes_of(to), "new");
}

}  // namespace
