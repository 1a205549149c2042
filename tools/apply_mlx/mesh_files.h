// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <common/ml_document/mesh_document.h>

namespace apply_mlx {

/// Reads a mesh by MeshLab's plugin for its format and puts it into the document.
/// @return which attributes the file has, as vcg::tri::io::Mask bits
/// @throws Failure if there is no such file, no plugin reads the format, or the file is damaged
int read_mesh(const QString& path, MeshDocument& document);

/// @throws Failure if no plugin writes the format, or nothing can be written at this place
void check_writable(const QString& path);

/// Writes the mesh with the attributes that its file had (`attributes`) and those that filters have made; with it what
/// belongs to it: materials, and textures (see textures.h), which may lie in folders below the mesh's own and never
/// outside. Written aside, flushed to the disk and then moved: an existing file is replaced by a complete one or stays.
/// @throws Failure if it cannot be written
void write_mesh(MeshModel& mesh, int attributes, const QString& path);

}  // namespace apply_mlx
