// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <cerrno>

namespace durable_files {

/// Flushes an open file or folder to the disk. True as well where the file system cannot; otherwise errno tells.
inline bool flush(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == EOPNOTSUPP || errno == ENOSYS; }

}  // namespace durable_files
