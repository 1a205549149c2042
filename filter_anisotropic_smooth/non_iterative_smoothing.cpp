#include "non_iterative_smoothing.h"

namespace meshlab_plugin {

NonIterativeSmoothing::NonIterativeSmoothing()
    : SmoothingFilter(vcg_core::Method::jones, {&knobs::sigma_c, &knobs::sigma_s, &knobs::boundary, &knobs::selected}) {
}

QString NonIterativeSmoothing::name() const { return QStringLiteral("Non-Iterative Feature-Preserving Smoothing"); }

QString NonIterativeSmoothing::python_name() const { return QStringLiteral("apply_coord_non_iterative_smoothing"); }

QString NonIterativeSmoothing::help() const {
  return QStringLiteral(
      "Removes noise from scans and from smooth surfaces, in one pass, and keeps soft features. Sharp edges and thin"
      " parts are kept better by <i>Anisotropic Feature-Preserving Smoothing</i>.<br>"
      "Each face nearby predicts where a vertex belongs: on the face's plane, whose normal is taken from a smoothed"
      " copy of the mesh. The vertex moves to the mean of the predictions, in any direction; a face counts more the"
      " larger it is, less the farther away it is (sigma_c) and the farther off its prediction lies (sigma_s). Faces"
      " count whether they are connected or not.<br>"
      "A vertex with no centre of a face within 2 sigma_c stays where it is; the log counts them. Lengths are in"
      " multiples of the mesh's average edge length; the log tells them in the mesh's unit. Only vertex positions and"
      " normals change.<br>"
      "See: <b>Jones, Durand, Desbrun: \"Non-Iterative, Feature-Preserving Mesh Smoothing\", 2003</b>.");
}

}  // namespace meshlab_plugin
