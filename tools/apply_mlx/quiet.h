// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace apply_mlx {

/// While it lives, what the process writes to its standard streams goes nowhere: MeshLab's library and plugins print
/// what they come by, and users are promised one line.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  int output_, error_;
};

}  // namespace apply_mlx
