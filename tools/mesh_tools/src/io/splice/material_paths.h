#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mesh_tools::io {

/// The file names of an OBJ file's mtllib statement, for an OBJ file in another folder that means the same files.
/// Several names are told from one name with spaces by which files there are. Absolute names stay, and so do all where
/// both folders are one, or where what a statement with spaces names is not there.
/// @param names  the statement behind the word mtllib
std::string moved_material_names(std::string_view names, const std::filesystem::path& from_folder,
                                 const std::filesystem::path& to_folder);

}  // namespace mesh_tools::io
