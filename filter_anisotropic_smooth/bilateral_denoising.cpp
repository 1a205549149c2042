#include "bilateral_denoising.h"

namespace meshlab_plugin {

BilateralDenoising::BilateralDenoising()
    : SmoothingFilter(vcg_core::Method::bmd,
                      {&knobs::sigma_c, &knobs::sigma_s, &knobs::iterations, &knobs::boundary, &knobs::selected}) {}

QString BilateralDenoising::name() const { return QStringLiteral("Bilateral Mesh Denoising"); }

QString BilateralDenoising::python_name() const { return QStringLiteral("apply_coord_bilateral_denoising"); }

QString BilateralDenoising::help() const {
  return QStringLiteral(
      "Removes noise from smooth surfaces, quickly. For models with sharp edges or thin parts take"
      " <i>Anisotropic Feature-Preserving Smoothing</i>: this filter rounds edges, and draws thin parts together.<br>"
      "Each vertex moves along its normal by a weighted mean of the heights of its neighbours above its tangent plane. "
      "A"
      " neighbour counts less the farther away it is (sigma_c) and the higher it lies (sigma_s). Neighbours are all"
      " vertices within 2 sigma_c in a straight line, connected or not.<br>"
      "If noise is left, raise sigma_s, or use two passes. Lengths are in multiples of the mesh's average edge length;"
      " the log tells them in the mesh's unit. Only vertex positions and normals change.<br>"
      "See: <b>Fleishman, Drori, Cohen-Or: \"Bilateral Mesh Denoising\", 2003</b>, with the normals of one ring of"
      " faces and with sigma_s as a parameter.");
}

}  // namespace meshlab_plugin
