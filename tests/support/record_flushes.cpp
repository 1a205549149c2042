// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded in front of the C library (LD_PRELOAD), it notes what a program does to make its files last: a line
// "write|flush|rename PATH" in the file $RECORD_FLUSHES for each call that succeeds; of a rename, both paths.

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#define RECORDED extern "C" __attribute__((visibility("default")))

namespace {

template <class Function>
Function original(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

std::string path_of(int file) {
  char path[4096];
  const ssize_t length = ::readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path, sizeof path);
  return length > 0 ? std::string(path, static_cast<std::size_t>(length)) : std::string();
}

void note(const std::string& line) {
  const char* const name = std::getenv("RECORD_FLUSHES");
  if (name == nullptr) return;
  const int log = ::open(name, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (log < 0) return;
  const std::string text = line + "\n";
  static const auto write_it = original<ssize_t (*)(int, const void*, std::size_t)>("write");
  (void)!write_it(log, text.data(), text.size());
  ::close(log);
}

}  // namespace

RECORDED ssize_t write(int file, const void* bytes, std::size_t size) {
  static const auto call = original<ssize_t (*)(int, const void*, std::size_t)>("write");
  const ssize_t result = call(file, bytes, size);
  if (result > 0) note("write " + path_of(file));
  return result;
}

RECORDED int fsync(int file) {
  static const auto call = original<int (*)(int)>("fsync");
  const int result = call(file);
  if (result == 0) note("flush " + path_of(file));
  return result;
}

RECORDED int rename(const char* from, const char* to) {
  static const auto call = original<int (*)(const char*, const char*)>("rename");
  const int result = call(from, to);
  if (result == 0) note(std::string("rename ") + from + "\t" + to);
  return result;
}
