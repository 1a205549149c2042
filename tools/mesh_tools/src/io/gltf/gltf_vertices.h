// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <vcg/space/point3.h>

#include "gltf_file.h"

namespace mesh_tools::io {

/// A vector of three floats as its buffer holds it.
vcg::Point3f vector_at(const GltfFile& file, const GltfVectors& vectors, std::size_t index);
void set_vector(GltfFile& file, const GltfVectors& vectors, std::size_t index, const vcg::Point3f& value);

/// A vertex of the set, and its normal of unit length, in the world.
vcg::Point3d place_of(const GltfFile& file, const GltfVertices& set, std::size_t index);
vcg::Point3d normal_of(const GltfFile& file, const GltfVertices& set, std::size_t index);

/// What is to be in the buffer for a place or a direction in the world.
vcg::Point3f as_stored(const GltfVertices& set, const vcg::Point3d& place);
vcg::Point3f normal_as_stored(const GltfVertices& set, const vcg::Point3d& normal);

}  // namespace mesh_tools::io
