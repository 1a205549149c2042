#pragma once

namespace vcg_core {

/// The smoothing filters. Each says in its own file where it comes from and where it differs from its source.
enum class Method {
  paper  ///< Anisotropic Feature-Preserving Smoothing of 3D Mesh, sections 4 to 6
};

}  // namespace vcg_core
