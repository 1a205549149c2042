#include "smoothing_knobs.h"

#include <vcg_core/errors.h>

#include <array>
#include <charconv>
#include <cmath>

namespace meshlab_plugin {

namespace {

using vcg_core::SmoothingParameters;

template <double SmoothingParameters::*member>
void add_number(const Knob& knob, const SmoothingParameters& defaults, const MeshModel* /*mesh*/,
                RichParameterList& list) {
  const auto value = static_cast<ParameterNumber>(defaults.*member);
  list.addParam(RichFloat(knob.name, value, knob.label, knob.tooltip));
}

template <double SmoothingParameters::*member>
void read_number(const Knob& knob, const RichParameterList& values, SmoothingParameters& parameters) {
  parameters.*member = as_typed(values.getFloat(knob.name));
}

void add_iterations(const Knob& knob, const SmoothingParameters& defaults, const MeshModel* /*mesh*/,
                    RichParameterList& list) {
  list.addParam(RichInt(knob.name, defaults.iterations, knob.label, knob.tooltip));
}

void read_iterations(const Knob& knob, const RichParameterList& values, SmoothingParameters& parameters) {
  parameters.iterations = values.getInt(knob.name);
}

void add_boundary(const Knob& knob, const SmoothingParameters& defaults, const MeshModel* /*mesh*/,
                  RichParameterList& list) {
  const QStringList choices{QStringLiteral("fixed"), QStringLiteral("free")};
  list.addParam(RichEnum(knob.name, static_cast<int>(defaults.boundary), choices, knob.label, knob.tooltip));
}

void add_smooth_color(const Knob& knob, const SmoothingParameters& defaults, const MeshModel* /*mesh*/,
                      RichParameterList& list) {
  list.addParam(RichBool(knob.name, defaults.smooth_color, knob.label, knob.tooltip));
}

void read_smooth_color(const Knob& knob, const RichParameterList& values, SmoothingParameters& parameters) {
  parameters.smooth_color = values.getBool(knob.name);
}

void read_boundary(const Knob& knob, const RichParameterList& values, SmoothingParameters& parameters) {
  const int choice = values.getEnum(knob.name);
  if (choice != 0 && choice != 1) {
    throw vcg_core::InvalidParameter(std::string(knob.name) + " is " + std::to_string(choice) +
                                     "; it must be 0 (fixed) or 1 (free)");
  }
  parameters.boundary = choice == 0 ? vcg_core::Boundary::fixed : vcg_core::Boundary::free;
}

bool has_selection(const MeshModel* mesh) {
  if (mesh == nullptr) return false;
  for (const auto& vertex : mesh->cm.vert) {
    if (!vertex.IsD() && vertex.IsS()) return true;
  }
  for (const auto& face : mesh->cm.face) {
    if (!face.IsD() && face.IsS()) return true;
  }
  return false;
}

void add_selected(const Knob& knob, const SmoothingParameters& /*defaults*/, const MeshModel* mesh,
                  RichParameterList& list) {
  list.addParam(RichBool(knob.name, has_selection(mesh), knob.label, knob.tooltip));
}

void read_selected(const Knob& knob, const RichParameterList& values, SmoothingParameters& parameters) {
  parameters.selected_only = values.getBool(knob.name);
}

}  // namespace

namespace knobs {

const Knob sigma_c{"sigma_c", "Closeness (sigma_c), in average edge lengths",
                   "Standard deviation of the closeness weight. Higher: vertices from farther away take part, so larger"
                   " bumps are smoothed, thin details get lost, and time grows with the square. Above 0; the paper uses"
                   " 2 to 6. Unit: the mesh's average edge length.",
                   add_number<&SmoothingParameters::sigma_c>, read_number<&SmoothingParameters::sigma_c>};

const Knob sigma_s{"sigma_s", "Noise height (sigma_s), in average edge lengths",
                   "Standard deviation of the similarity weight: heights above the tangent plane up to about this count"
                   " as noise. Higher: stronger noise goes, and shallow features with it. Above 0; the paper uses 0.5"
                   " to 2. Unit: the mesh's average edge length.",
                   add_number<&SmoothingParameters::sigma_s>, read_number<&SmoothingParameters::sigma_s>};

const Knob sigma_n{
    "sigma_n", "Edge tolerance (sigma_n)",
    "Standard deviation of the normal weight, whose argument is 1 - cosine of the angle between two"
    " normals. Higher: the surface is smoothed across steeper edges; lower: more edges are kept, and more"
    " noise. Above 0; the paper uses 0.1 to 0.3. No unit.",
    add_number<&SmoothingParameters::sigma_n>, read_number<&SmoothingParameters::sigma_n>};

const Knob rho{"rho", "Cut-off distance (rho), in sigma_c",
               "Geodesic radius of the neighbourhood. Higher: more vertices of little weight take part, and time grows"
               " with the square. Above 0; the paper uses 2. Unit: sigma_c.",
               add_number<&SmoothingParameters::rho>, read_number<&SmoothingParameters::rho>};

const Knob iterations{"iterations", "Passes",
                      "How often the filter is applied. Higher: smoother, and edges get rounder. 1 or more; the paper"
                      " needs one, noise above 0.3 average edge lengths may want two.",
                      add_iterations, read_iterations};

const Knob boundary{"boundary", "Border vertices",
                    "fixed: vertices of border edges (edges with one face) stay where they are; free: they are smoothed"
                    " like all others.",
                    add_boundary, read_boundary};

const Knob selected{"selected", "Move selected vertices only",
                    "On: only selected vertices and the vertices of selected faces move; all others stay and still"
                    " serve as neighbours. The selection itself is never changed.",
                    add_selected, read_selected};

const Knob strength{
    "strength", "Strength",
    "1: as strong as the mesh's own noise asks for. Higher: more is taken for noise, so that smooth"
    " surfaces get smoother, shallow features go, and from about 1.5 on edges get round; lower: more of the"
    " surface stays as it is, and noise with it. Above 0, at most 10; 0.5 is gentle. No unit.",
    add_number<&SmoothingParameters::strength>, read_number<&SmoothingParameters::strength>};

const Knob feature_angle{"feature_angle", "Feature angle, in degrees",
                         "Edges at which faces meet at this angle or more stay sharp. Higher: shallower edges are"
                         " smoothed away; lower: they stay, and more noise with them. Above 0, at most 90.",
                         add_number<&SmoothingParameters::feature_angle>,
                         read_number<&SmoothingParameters::feature_angle>};

const Knob rounds{"iterations", "Coarse rounds (0: automatic)",
                  "How often the normals are filtered by their guides. 0: 2 to 12, by the noise. Higher: stronger noise"
                  " goes, and time grows with it. 0 or more.",
                  add_iterations, read_iterations};

const Knob boundary_of_guided{"boundary", "Border vertices",
                              "free: vertices of border edges (edges with one face) lose their noise like all others;"
                              " borders are not drawn inwards. fixed: they stay where they are.",
                              add_boundary, read_boundary};

const Knob smooth_color{"smooth_color", "Smooth colour and quality too",
                        "On: the vertices' colour and quality are smoothed as well, without bleeding over edges. Off:"
                        " they stay byte for byte as they are.",
                        add_smooth_color, read_smooth_color};

}  // namespace knobs

RichParameterList to_list(const Knobs& knobs, const SmoothingParameters& defaults, const MeshModel* mesh) {
  RichParameterList list;
  for (const Knob* knob : knobs) knob->add(*knob, defaults, mesh, list);
  return list;
}

SmoothingParameters read_values(const Knobs& knobs, const RichParameterList& values, SmoothingParameters parameters) {
  for (const Knob* knob : knobs) knob->read(*knob, values, parameters);
  return parameters;
}

double as_typed(float value) {
  if (!std::isfinite(value)) return value;
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  double typed = value;
  std::from_chars(text.data(), written.ptr, typed);
  return typed;
}

}  // namespace meshlab_plugin
