// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace mesh_tools::io {

/// Wishes that memory which nothing has touched yet comes in the system's large pages: of a file of a hundred
/// megabytes, small ones take longer than its bytes. Where the wish is not granted, nothing is lost.
void wish_for_large_pages(void* begin, std::size_t bytes) noexcept;

/// Room for `size` elements of a string or a vector that is empty.
template <class Container>
void reserve_in_large_pages(Container& container, std::size_t size) {
  container.reserve(size);
  wish_for_large_pages(container.data(), size * sizeof(typename Container::value_type));
}

}  // namespace mesh_tools::io
