// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace test_support {

/// From now on, on this thread, `new` succeeds `count` times and then throws std::bad_alloc. The source replaces the
/// global operator new, so it belongs to no library: the program that uses it names it.
void fail_allocations_after(std::size_t count);

/// Ends that; returns whether any has failed.
bool allow_allocations();

}  // namespace test_support
