// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

namespace anisosmooth_python {

namespace nb = nanobind;

vcg_core::IndexRows index_rows(const ReadOnlyArray& array) {
  const std::ptrdiff_t stride = row_stride(array);
  if (array.dtype() == nb::dtype<std::int32_t>())
    return vcg_core::index_rows(static_cast<const std::int32_t*>(array.data()), stride);
  if (array.dtype() == nb::dtype<std::uint32_t>())
    return vcg_core::index_rows(static_cast<const std::uint32_t*>(array.data()), stride);
  if (array.dtype() == nb::dtype<std::uint64_t>())
    return vcg_core::index_rows(static_cast<const std::uint64_t*>(array.data()), stride);
  return vcg_core::index_rows(static_cast<const std::int64_t*>(array.data()), stride);
}

vcg_core::RealRows real_rows(const ReadOnlyArray& array) {
  void* first = const_cast<void*>(array.data());  // see MeshView
  if (array.dtype() == nb::dtype<float>()) return vcg_core::real_rows(static_cast<float*>(first), row_stride(array));
  return vcg_core::real_rows(static_cast<double*>(first), row_stride(array));
}

vcg_core::MeshView view_of(const ReadOnlyArray& positions, const ReadOnlyArray& faces) {
  vcg_core::MeshView view;
  view.vertices = positions.shape(0);
  view.faces = faces.shape(0);
  view.positions = real_rows(positions);
  view.triangles = index_rows(faces);
  return view;
}

}  // namespace anisosmooth_python
