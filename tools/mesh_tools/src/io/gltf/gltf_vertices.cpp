// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_vertices.h"

#include "../binary.h"

namespace mesh_tools::io {
namespace {

using vcg::Point3d;
using vcg::Point3f;

/// Zero if the vector has no direction.
Point3d unit(const Point3d& vector) {
  const double length = vector.Norm();
  return length > 0 ? vector / length : Point3d(0, 0, 0);
}

/// The product of the upper left part with a vector, or with its transpose.
Point3d linear(const vcg::Matrix44d& matrix, const Point3d& vector, bool transposed) {
  Point3d result(0, 0, 0);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result[i] += matrix.ElementAt(transposed ? k : i, transposed ? i : k) * vector[k];
  return result;
}

Point3f rounded(const Point3d& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

Point3d exact(const Point3f& p) { return {p[0], p[1], p[2]}; }

}  // namespace

Point3f vector_at(const GltfFile& file, const GltfVectors& vectors, std::size_t index) {
  const char* at = file.buffers[vectors.buffer].bytes.data() + vectors.offset + index * vectors.stride;
  Point3f result;
  for (int k = 0; k < 3; ++k, at += sizeof(float)) result[k] = number_at<float>(at);
  return result;
}

void set_vector(GltfFile& file, const GltfVectors& vectors, std::size_t index, const Point3f& value) {
  char* at = file.buffers[vectors.buffer].bytes.data() + vectors.offset + index * vectors.stride;
  for (int k = 0; k < 3; ++k, at += sizeof(float)) put_number(at, value[k]);
}

Point3d place_of(const GltfFile& file, const GltfVertices& set, std::size_t index) {
  const Point3d stored = exact(vector_at(file, set.positions, index));
  return set.is_in_world ? stored : set.to_world * stored;
}

Point3d normal_of(const GltfFile& file, const GltfVertices& set, std::size_t index) {
  const Point3d stored = exact(vector_at(file, *set.normals, index));
  return unit(set.is_in_world ? stored : linear(set.from_world, stored, true));
}

Point3f as_stored(const GltfVertices& set, const Point3d& place) {
  return rounded(set.is_in_world ? place : set.from_world * place);
}

Point3f normal_as_stored(const GltfVertices& set, const Point3d& normal) {
  return rounded(unit(set.is_in_world ? normal : linear(set.to_world, normal, true)));
}

}  // namespace mesh_tools::io
