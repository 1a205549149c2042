// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include <QString>

namespace apply_mlx {

/// What ends the work, as one line for the user.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const QString& what) : std::runtime_error(what.simplified().toStdString()) {}
};

}  // namespace apply_mlx
