// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace anisosmooth {

/// From here on SIGINT, SIGTERM and SIGHUP (the terminal was closed; not if it was ignored, as by nohup) end the
/// program with status 130: at once, or, while a CooperativeInterrupt lives, when the program next asks interrupted().
void handle_interrupts();

bool interrupted();

/// From here on the signals change nothing: what the user asked for is in its place, and status 0 says so.
void result_is_in_place();

/// Marks a stretch of work that has something to tidy up and asks interrupted() often.
class CooperativeInterrupt {
 public:
  CooperativeInterrupt();
  ~CooperativeInterrupt();
  CooperativeInterrupt(const CooperativeInterrupt&) = delete;
  CooperativeInterrupt& operator=(const CooperativeInterrupt&) = delete;
};

}  // namespace anisosmooth
