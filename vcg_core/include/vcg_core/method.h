#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <vcg_core/smoothing_parameters.h>

namespace vcg_core {

/// The smoothing filters. Each says in its own file where it comes from and where it differs from its source.
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
  std::string name;                     ///< short and stable, for command lines and files
  std::string title;                    ///< for people
  std::vector<std::string> parameters;  ///< fields of SmoothingParameters, beyond those that all methods obey
                                        ///< (boundary, selected_only, threads); the others have no effect
  SmoothingParameters defaults;         ///< the paper's Table 1; for guided what fits any mesh
  int fewest_iterations = 1;            ///< 0 where 0 means that the method chooses by itself

  bool uses(std::string_view parameter) const;
};

/// All methods, in the order of the enumeration.
const std::vector<MethodInfo>& methods();

const MethodInfo& method_info(Method method);

/// The name of a method, such as "paper".
const std::string& method_name(Method method);

/// The method of that name; empty if there is none.
std::optional<Method> method_from_name(std::string_view name);

}  // namespace vcg_core
