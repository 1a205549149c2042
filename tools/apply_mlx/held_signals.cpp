// SPDX-License-Identifier: GPL-3.0-or-later
#include "held_signals.h"

namespace apply_mlx {
namespace {

volatile std::sig_atomic_t held = 0;

extern "C" void hold(int number) { held = number; }

}  // namespace

// Handlers, not a mask: the threads of MeshLab and Qt would take the signals that this one does not.
HeldSignals::HeldSignals() {
  held = 0;
  for (int i = 0; i < 3; ++i) {
    struct sigaction holding = {};
    holding.sa_handler = hold;
    holding.sa_flags = SA_RESTART;
    ::sigaction(numbers_[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(numbers_[i], &holding, nullptr);
  }
}

HeldSignals::~HeldSignals() {
  for (int i = 0; i < 3; ++i) ::sigaction(numbers_[i], &before_[i], nullptr);
  if (held != 0) (void)std::raise(held);
}

bool HeldSignals::any() { return held != 0; }

}  // namespace apply_mlx
