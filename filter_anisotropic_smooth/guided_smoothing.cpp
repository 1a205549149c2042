#include "guided_smoothing.h"

namespace meshlab_plugin {

GuidedSmoothing::GuidedSmoothing()
    : SmoothingFilter(vcg_core::Method::guided, {&knobs::strength, &knobs::feature_angle, &knobs::rounds,
                                                 &knobs::boundary_of_guided, &knobs::selected, &knobs::smooth_color}) {}

QString GuidedSmoothing::name() const { return QStringLiteral("Guided Anisotropic Smoothing"); }

QString GuidedSmoothing::python_name() const { return QStringLiteral("apply_coord_guided_anisotropic_smoothing"); }

QString GuidedSmoothing::help() const {
  return QStringLiteral(
      "Removes noise, keeps sharp edges, thin parts and the fine detail of scans, and chooses its strength by the noise"
      " of the mesh: for most meshes the defaults are what to use. It goes beyond <i>Anisotropic Feature-Preserving"
      " Smoothing</i>, the paper's one pass, most of all on strong noise and on scans.<br>"
      "The normals of the faces are filtered first, then the vertices moved until the faces look along them; what was"
      " removed and is no noise comes back. If noise is left, raise the strength a little, to 1.2: much more rounds the"
      " edges. If shallow edges are lost, lower the feature angle. Vertex positions and normals change, and on request"
      " colour and quality.<br>"
      "See: <b>Zhang, Deng, Zhang, Bouaziz, Liu: \"Guided Mesh Normal Filtering\", 2015</b>, <b>Zheng, Fu, Au, Tai:"
      " \"Bilateral Normal Filtering for Mesh Denoising\", 2011</b> and <b>Sun, Rosin, Martin, Langbein: \"Fast and"
      " Effective Feature-Preserving Mesh Denoising\", 2007</b>, from which the parts come that are not new.");
}

int GuidedSmoothing::changes() const {
  return SmoothingFilter::changes() | MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY;
}

int GuidedSmoothing::changes_with(const RichParameterList& values) const {
  return values.getBool(knobs::smooth_color.name) ? changes() : SmoothingFilter::changes();
}

}  // namespace meshlab_plugin
