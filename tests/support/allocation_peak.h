// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace test_support {

/// The most memory that was taken by `new` at one time since this object was made, beyond what was taken before. Its
/// source replaces the global operator new, so it belongs to no library: the program that uses it names it.
class AllocationPeak {
 public:
  AllocationPeak();
  std::size_t bytes() const;

 private:
  std::size_t before_;
};

}  // namespace test_support
