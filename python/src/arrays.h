// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <vcg_core/mesh/mesh_view.h>

namespace anisosmooth_python {

/// An array of numpy, of any type and with any strides. The Python side of the package has checked type and shape.
using Array = nanobind::ndarray<nanobind::device::cpu>;
using ReadOnlyArray = nanobind::ndarray<nanobind::ro, nanobind::device::cpu>;

/// Bytes from one row to the next.
template <class AnyArray>
std::ptrdiff_t row_stride(const AnyArray& array) {
  return static_cast<std::ptrdiff_t>(array.stride(0)) * array.itemsize();
}

vcg_core::RealRows real_rows(const ReadOnlyArray& array);
vcg_core::IndexRows index_rows(const ReadOnlyArray& array);

/// A view of positions, three numbers a row, and faces, three indices a row. It is written to by smooth() only.
vcg_core::MeshView view_of(const ReadOnlyArray& positions, const ReadOnlyArray& faces);

/// A new array of numpy that owns the numbers: one row of `width` numbers for each item, or, of width 0, one number.
template <class Number>
nanobind::object to_array(std::vector<Number> numbers, std::size_t width = 0) {
  auto* kept = new std::vector<Number>(std::move(numbers));
  const nanobind::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<Number>*>(p); });
  const std::size_t shape[] = {width == 0 ? kept->size() : kept->size() / width, width};
  return nanobind::cast(nanobind::ndarray<nanobind::numpy, Number>(kept->data(), width == 0 ? 1 : 2, shape, owner));
}

}  // namespace anisosmooth_python
