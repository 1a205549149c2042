// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Names of files in mesh files, for a mesh file in another folder that means the same files. A name that means no file
/// stays as it is, as do absolute names, and all where both folders are one. Names may have Windows' separators; those
/// that change get slashes.
namespace mesh_tools::io {

/// The name of a texture.
std::string moved_file_name(std::string_view name, const std::filesystem::path& from_folder,
                            const std::filesystem::path& to_folder);

/// The file names of an OBJ file's mtllib statement. Several names are told from one name with spaces by which files
/// there are. A single name changes whether or not the file is there.
/// @param names  the statement behind the word mtllib
std::string moved_material_names(std::string_view names, const std::filesystem::path& from_folder,
                                 const std::filesystem::path& to_folder);

}  // namespace mesh_tools::io
