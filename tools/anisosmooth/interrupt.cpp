// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.h"

#include <csignal>
#include <cstdlib>

#include "command.h"

namespace anisosmooth {
namespace {

volatile std::sig_atomic_t was_interrupted = 0;
volatile std::sig_atomic_t cooperative = 0;
volatile std::sig_atomic_t in_place = 0;

extern "C" void on_interrupt(int number) {
  std::signal(number, on_interrupt);  // Windows forgets it
  if (in_place) return;
  if (!cooperative) std::_Exit(interrupted_status);
  was_interrupted = 1;
}

}  // namespace

void handle_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
#ifdef SIGHUP
  // Whoever starts a program with nohup wants it to outlive the terminal.
  if (std::signal(SIGHUP, on_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
#endif
}

bool interrupted() { return was_interrupted != 0; }

void result_is_in_place() { in_place = 1; }

CooperativeInterrupt::CooperativeInterrupt() { cooperative = cooperative + 1; }
CooperativeInterrupt::~CooperativeInterrupt() { cooperative = cooperative - 1; }

}  // namespace anisosmooth
