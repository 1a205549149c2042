// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <vcg_core/filters/common_parameters.h>

namespace vcg_core {

/// Where the guided filter's last normals come from.
enum class Blend {
  on,  ///< a learned blend of differently filtered ones
  off  ///< the last rounds of one filter
};

/// What the guided filter is told; by default it sets itself by the mesh.
struct GuidedParameters {
  double strength = 1.0;
  double feature_angle = 30.0;
  bool smooth_color = false;
  Blend blend = Blend::on;
};

/// All is SmoothingParameters, which is not complete here.
template <class All>
std::vector<ParameterInfo> guided_parameters() {
  const CommonRows<All> common;
  return {
      {&All::strength, "strength", "Strength",
       "1: as strong as the mesh's own noise asks for. Higher: more is taken for noise, so that smooth surfaces get"
       " smoother, shallow features go, and from about 1.5 on edges get round; lower: more of the surface stays as"
       " it is, and noise with it.",
       above(0, 10), "0.5 is gentle", ""},
      {&All::feature_angle, "feature_angle", "Feature angle, in degrees",
       "Edges at which faces meet at this angle or more stay sharp. Higher: shallower edges are smoothed away;"
       " lower: they stay, and more noise with them.",
       above(0, 90), "", "degrees"},
      {&All::iterations, "iterations", "Coarse rounds (0: automatic)",
       "How often the normals are filtered by their guides. 0: 2 to 12, by the noise. Higher: stronger noise goes,"
       " and time grows with it.",
       at_least(0, "automatic")},
      {&All::boundary, "boundary", "Border vertices",
       "free: vertices of border edges (edges with one face) lose their noise like all others; borders are not"
       " drawn inwards. fixed: they stay where they are.",
       common.boundary.values},
      common.selected,
      {&All::smooth_color, "smooth_color", "Smooth colour and quality too",
       "On: the vertices' colour and quality are smoothed as well, without bleeding over edges. Off: they stay byte"
       " for byte as they are.",
       on_or_off()},
      {&All::blend, "blend", "",
       "on: the final normals are a learned blend of differently filtered ones, which leaves less noise and makes no"
       " facets of curved surfaces. off: they are those of the last filtering rounds, and detail is brought back"
       " afterwards: faster, and what the blend is measured against.",
       one_of({"on", "off"})}};
}

}  // namespace vcg_core
