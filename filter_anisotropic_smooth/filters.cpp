// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

#include "geodesic_distance.h"
#include "smoothing_filter.h"

namespace meshlab_plugin {

std::vector<Filter> all_filters() {
  using vcg_core::Method;
  return {
      smoothing_filter(
          Method::paper, "Anisotropic Feature-Preserving Smoothing", "apply_coord_anisotropic_smoothing",
          "Removes noise and keeps sharp edges and corners, in one pass. Use it on scans and on noisy models with"
          " edges, where Laplacian or Taubin smoothing would round them; for noise up to about 0.2 average edge"
          " lengths the defaults are good.<br>"
          "Each vertex moves along its normal by a weighted mean of its neighbours' heights. A neighbour counts less"
          " the farther away it is (sigma_c), the higher it lies (sigma_s) and the more its normal differs (sigma_n)."
          " Distances run along the surface.<br>"
          "If noise is left, raise sigma_s or use two passes; if edges get round, lower sigma_n. The log tells all"
          " lengths in the mesh's unit. Only positions and normals change. Vertices at exactly the same place move as"
          " one.<br>"
          "Coarse convex shapes are blown up: a cube of 12 triangles gains 38 % of volume, a cylinder of 32 sides 97"
          " %, a sphere of 10,000 vertices 1.2 %. Use <i>Guided Anisotropic Smoothing</i> there.<br>"
          "See: <b>\"Anisotropic Feature-Preserving Smoothing of 3D Mesh\"</b>, sections 4 to 6."),
      geodesic_distance_filter(),
      smoothing_filter(
          Method::bmd, "Bilateral Mesh Denoising", "apply_coord_bilateral_denoising",
          "Removes noise from smooth surfaces, quickly. For models with sharp edges or thin parts take <i>Anisotropic"
          " Feature-Preserving Smoothing</i>: this filter rounds edges, and draws thin parts together.<br>"
          "Each vertex moves along its normal by a weighted mean of the heights of its neighbours above its tangent"
          " plane. A neighbour counts less the farther away it is (sigma_c) and the higher it lies (sigma_s)."
          " Neighbours are all vertices within 2 sigma_c in a straight line, connected or not.<br>"
          "If noise is left, raise sigma_s, or use two passes. Lengths are in multiples of the mesh's average edge"
          " length; the log tells them in the mesh's unit. Only vertex positions and normals change.<br>"
          "See: <b>Fleishman, Drori, Cohen-Or: \"Bilateral Mesh Denoising\", 2003</b>, with the normals of one ring"
          " of faces and with sigma_s as a parameter."),
      smoothing_filter(
          Method::jones, "Non-Iterative Feature-Preserving Smoothing", "apply_coord_non_iterative_smoothing",
          "Removes noise from scans and from smooth surfaces, in one pass, and keeps soft features. Sharp edges and"
          " thin parts are kept better by <i>Anisotropic Feature-Preserving Smoothing</i>.<br>"
          "Each face nearby predicts where a vertex belongs: on the face's plane, whose normal is taken from a"
          " smoothed copy of the mesh. The vertex moves to the mean of the predictions, in any direction; a face"
          " counts more the larger it is, less the farther away it is (sigma_c) and the farther off its prediction"
          " lies (sigma_s). Faces count whether they are connected or not.<br>"
          "A vertex with no centre of a face within 2 sigma_c stays where it is; the log counts them. Lengths are in"
          " multiples of the mesh's average edge length; the log tells them in the mesh's unit. Only vertex positions"
          " and normals change.<br>"
          "See: <b>Jones, Durand, Desbrun: \"Non-Iterative, Feature-Preserving Mesh Smoothing\", 2003</b>."),
      smoothing_filter(
          Method::guided, "Guided Anisotropic Smoothing", "apply_coord_guided_anisotropic_smoothing",
          "Removes noise, keeps sharp edges, thin parts and the fine detail of scans, and chooses its strength by the"
          " noise of the mesh: for most meshes the defaults are what to use. It goes beyond <i>Anisotropic"
          " Feature-Preserving Smoothing</i>, the paper's one pass, most of all on strong noise and on scans.<br>"
          "The normals of the faces are filtered first, then the vertices moved until the faces look along them; what"
          " was removed and is no noise comes back. If noise is left, raise the strength a little, to 1.2: much more"
          " rounds the edges. If shallow edges are lost, lower the feature angle. Vertex positions and normals"
          " change, and on request colour and quality.<br>"
          "See: <b>Zhang, Deng, Zhang, Bouaziz, Liu: \"Guided Mesh Normal Filtering\", 2015</b>, <b>Zheng, Fu, Au,"
          " Tai: \"Bilateral Normal Filtering for Mesh Denoising\", 2011</b> and <b>Sun, Rosin, Martin, Langbein:"
          " \"Fast and Effective Feature-Preserving Mesh Denoising\", 2007</b>, from which the parts come that are"
          " not new."),
  };
}

}  // namespace meshlab_plugin
