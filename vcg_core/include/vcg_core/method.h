// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <vcg_core/smoothing_parameters.h>

namespace vcg_core {

/// The smoothing filters. Each says in its own folder, src/filters/<name>, where it comes from and where it differs
/// from its source.
enum class Method {
  paper,      ///< Anisotropic Feature-Preserving Smoothing of 3D Mesh, sections 4 to 6
  bmd,        ///< bilateral mesh denoising: Fleishman, Drori, Cohen-Or 2003; section 3
  jones,      ///< non-iterative, feature-preserving mesh smoothing: Jones, Durand, Desbrun 2003
  laplacian,  ///< vcglib's Laplacian smoothing
  hc,         ///< improved Laplacian smoothing: Vollmer, Mencl, Mueller 1999
  hc_vcglib,  ///< what vcglib has by that name, with a sign unlike the article's
  taubin,     ///< vcglib's Taubin smoothing: Taubin 1995
  guided      ///< guided anisotropic smoothing: this project's own, beyond the paper; docs/guided.md
};

/// What a program needs to know to offer a method.
struct MethodInfo {
  Method method;
  std::string name;                       ///< short and stable, for command lines and files
  std::string title;                      ///< for people
  std::vector<ParameterInfo> parameters;  ///< all that the method obeys, in the order of MeshLab's dialog
  SmoothingParameters defaults = {};      ///< the paper's Table 1; for guided what fits any mesh

  /// The row of a member such as &SmoothingParameters::rho; null if the method does not obey it.
  const ParameterInfo* find(const ParameterInfo::Member& member) const;
  bool uses(const ParameterInfo::Member& member) const { return find(member) != nullptr; }
};

/// All methods, in the order of the enumeration.
const std::vector<MethodInfo>& methods();

const MethodInfo& method_info(Method method);

/// The name of a method, such as "paper".
const std::string& method_name(Method method);

/// The method of that name; empty if there is none.
std::optional<Method> method_from_name(std::string_view name);

/// The same as a user gave it.
/// @throws InvalidParameter with the name and all that are allowed
const MethodInfo& method_info(std::string_view name);

}  // namespace vcg_core
