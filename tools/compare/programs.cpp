// SPDX-License-Identifier: GPL-3.0-or-later
#include "programs.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace anisosmooth {

bool has_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && ::access(folder.append("/").append(name).c_str(), X_OK) == 0) return true;
  return false;
}

namespace {

/// While it lives, the programs that end leave their status, also where the parent of this process had it ignore them.
class KeptStatuses {
 public:
  KeptStatuses() {
    struct sigaction plain = {};
    plain.sa_handler = SIG_DFL;
    ::sigaction(SIGCHLD, &plain, &before_);
  }
  ~KeptStatuses() { ::sigaction(SIGCHLD, &before_, nullptr); }
  KeptStatuses(const KeptStatuses&) = delete;
  KeptStatuses& operator=(const KeptStatuses&) = delete;

 private:
  struct sigaction before_ = {};
};

/// The status of the program once it has ended; ends it, with all that it has started, when `stop` says so.
int wait_for(pid_t process, const std::function<bool()>& stop) {
  constexpr std::chrono::milliseconds between_polls(20);
  int status = 0;
  pid_t ended = 0;
  bool stopped = false;
  while (ended != process) {
    ended = ::waitpid(process, &status, stopped ? 0 : WNOHANG);
    if (ended < 0 && errno != EINTR) throw std::runtime_error("the status of a program is lost");
    if (ended != 0) continue;
    if (stop()) {
      ::kill(-process, SIGTERM);
      stopped = true;
    } else {
      std::this_thread::sleep_for(between_polls);
    }
  }
  return status;
}

}  // namespace

int run_program(const std::vector<std::string>& command, const std::filesystem::path& folder, const std::string& log,
                const std::function<bool()>& stop) {
  // The folder is entered by a shell that then becomes the program: there is no portable way to spawn elsewhere.
  std::vector<std::string> words = {"sh", "-c", "cd \"$0\" && exec \"$@\"", folder.string()};
  words.insert(words.end(), command.begin(), command.end());
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, (folder / log).c_str(), O_WRONLY | O_CREAT | O_APPEND,
                                   0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  // A process group of its own: what the program has started can then be stopped with it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const KeptStatuses scope;
  pid_t process = 0;
  const int error = posix_spawnp(&process, "sh", &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " + command.front());
  const int status = wait_for(process, stop);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace anisosmooth
