#pragma once

#include "meshlab_compatibility.h"

#include <vcg_core/smoothing_parameters.h>

#include <vector>

namespace meshlab_plugin {

/// A parameter in the dialog of a smoothing filter: how it is offered, and how its value reaches the core. Filters pick
/// the knobs that they have; each is described once, in smoothing_knobs.cpp.
struct Knob {
  const char* name;
  const char* label;
  const char* tooltip;
  void (*add)(const Knob& knob, const vcg_core::SmoothingParameters& defaults, const MeshModel* mesh,
              RichParameterList& list);
  void (*read)(const Knob& knob, const RichParameterList& values, vcg_core::SmoothingParameters& parameters);
};

namespace knobs {
extern const Knob sigma_c;
extern const Knob sigma_s;
extern const Knob sigma_n;
extern const Knob rho;
extern const Knob iterations;
extern const Knob boundary;
extern const Knob selected;
// Of the guided filter.
extern const Knob strength;
extern const Knob feature_angle;
extern const Knob rounds;              ///< "iterations", with 0 for automatic
extern const Knob boundary_of_guided;  ///< "boundary", described for it
extern const Knob smooth_color;
}  // namespace knobs

/// Knobs in the order of the dialog.
using Knobs = std::vector<const Knob*>;

RichParameterList to_list(const Knobs& knobs, const vcg_core::SmoothingParameters& defaults, const MeshModel* mesh);

/// Replaces in `parameters`, the method's defaults, what the knobs hold.
/// @throws vcg_core::InvalidParameter for a choice that does not exist; ranges of numbers are the core's to check
vcg_core::SmoothingParameters read_values(const Knobs& knobs, const RichParameterList& values,
                                          vcg_core::SmoothingParameters parameters);

/// The number that a person meant who typed what was then stored as `value`: the shortest decimal that gives it. So 0.3
/// is 0.3 and not 0.300000012, and dialog, script and command line compute the same: always up to six digits. What a
/// MeshLab that stores single precision has rounded away beyond that is lost before the plugin sees the value.
double as_typed(float value);
inline double as_typed(double value) { return value; }

}  // namespace meshlab_plugin
