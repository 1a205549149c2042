// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <string>
#include <vector>

#include <QDir>
#include <QString>

#include <common/ml_document/mesh_document.h>

namespace apply_mlx {

/// MeshLab's reader names a texture that it does not find "dummy.png" and goes on; this gives the name of the file
/// back.
/// @param missing  the names that were not found, in the order of the meshes and of their textures
void keep_missing_names(const std::list<MeshModel*>& meshes, const std::list<std::string>& missing);

/// Writes a mesh's textures into the folder `aside`, from where they are to be moved to `folder`, that of the mesh.
/// Those that no filter has changed are copies of their files. A relative name stays. A name that leads out of
/// `folder`, by
/// "..", an absolute path or a link, stays only if that file is there already, as it is to be; otherwise the texture
/// loses the directory and gets the first name of NAME.png, NAME_1.png ... that is free, and the mesh gets that name.
/// Textures that were not found are left out.
/// @param taken  a name in `folder` that no texture may get
/// @return  paths relative to `aside` and `folder` alike; those that are there already are not among them
/// @throws MLException if MeshLab cannot write a picture
std::vector<QString> put_textures_aside(MeshModel& mesh, const QDir& folder, const QDir& aside, const QString& taken);

}  // namespace apply_mlx
