// SPDX-License-Identifier: GPL-3.0-or-later
#include "quiet.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace apply_mlx {
namespace {

void flush() {
  std::fflush(nullptr);
  std::cout.flush();
  std::cerr.flush();
}

}  // namespace

Quiet::Quiet() {
  flush();
  output_ = ::dup(STDOUT_FILENO);
  error_ = ::dup(STDERR_FILENO);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

Quiet::~Quiet() {
  flush();
  ::dup2(output_, STDOUT_FILENO);
  ::dup2(error_, STDERR_FILENO);
  ::close(output_);
  ::close(error_);
}

}  // namespace apply_mlx
