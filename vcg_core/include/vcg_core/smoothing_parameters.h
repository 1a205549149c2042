#pragma once

namespace vcg_core {

/// Whether the vertices of border edges (edges with one face) move. The paper is silent about borders.
enum class Boundary { fixed, free };

/// The exponent of the three weights. The paper prints W_c and W_s as exp(-x^2 / sigma^2) (section 3) and W_n as
/// exp(-x^2 / (2 sigma^2)) (section 6), yet calls every sigma a standard deviation (section 7).
enum class GaussianForm {
  standard_deviation,  ///< exp(-x^2 / (2 sigma^2)) for all three: the default
  printed              ///< as printed
};

/// How the paper's filter computes distances and weights. Positions are read and moved in double precision either way.
enum class Arithmetic {
  fast,      ///< in single precision, many vertices at once: within 1e-4 |e| of the other at 99.9 % of the vertices
  reference  ///< in double precision, vertex by vertex, by the plainest code
};

/// Parameters of the smoothing filters, with the defaults of the paper's Table 1. Lengths are in multiples of |e|,
/// the average length of the mesh's unique edges.
struct SmoothingParameters {
  /// Standard deviation of the closeness weight W_c, in |e|; > 0. The paper uses 2 to 6.
  double sigma_c = 2.0;
  /// Standard deviation of the similarity weight W_s, in |e|; > 0. The paper uses 0.5 to 2.
  double sigma_s = 1.0;
  /// Standard deviation of the normal weight W_n, whose argument 1 - n_i.n_j has no unit; > 0. The paper uses 0.1-0.3.
  double sigma_n = 0.3;
  /// Cut-off distance of the neighbourhood, in multiples of sigma_c; > 0. The paper uses 2.
  double rho = 2.0;
  /// Number of passes; >= 1. The paper needs one. Of the guided method: number of coarse rounds; 0: by the noise.
  int iterations = 1;
  Boundary boundary = Boundary::fixed;
  /// If set, only selected vertices and the vertices of selected faces move; all vertices serve as neighbours.
  bool selected_only = false;
  GaussianForm gaussian = GaussianForm::standard_deviation;
  Arithmetic arithmetic = Arithmetic::fast;
  /// Guided method: strength of smoothing, as a multiple of what the mesh's own noise asks for; > 0, at most 10.
  double strength = 1.0;
  /// Guided method: angle between faces, in degrees, from which an edge is kept sharp rather than smoothed; > 0, at
  /// most 90. Noise can hide edges above it and leave some below it.
  double feature_angle = 30.0;
  /// Guided method: smooths per-vertex colour and quality as well, where the mesh has them, by weights that keep them
  /// from bleeding over edges.
  bool smooth_color = false;
  /// Also counts the faces of the result that cut through others: SmoothingReport::self_intersections.
  bool check = false;
  /// Number of threads; 0: one for each processor. The result does not depend on it.
  int threads = 0;

  /// Throws InvalidParameter with the name, the value and the allowed range of the first parameter that is out of
  /// range or not finite.
  /// @param fewest_iterations  as MethodInfo has it
  void validate(int fewest_iterations = 1) const;
};

}  // namespace vcg_core
