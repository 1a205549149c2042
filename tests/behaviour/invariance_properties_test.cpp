// SPDX-License-Identifier: GPL-3.0-or-later
// What must not matter to any method, on random meshes with random defects: where the mesh is, how it is turned, how
// large it is, in which order its elements come, which side its faces show, how many threads work. Shrunk on failure.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <support/comparison.h>
#include <support/draw.h>
#include <support/noisy_shapes.h>
#include <support/smoothed_by.h>

namespace {

using namespace test_support;
using vcg_core::Method;
using vcg_core::SmoothingParameters;

double draw_real(double low, double high) { return low + (high - low) * draw(0, 1000001) / 1e6; }

/// A noisy shape in general position (no two distances are equal by construction) with a random part of its faces
/// missing, doubled or turned, and vertices that are left without a face.
FlatMesh draw_mesh() {
  const std::vector<std::string> names = shape_names();
  const auto vertices = draw<std::size_t>(50, 300);
  FlatMesh mesh = noisy_shape(names[draw<std::size_t>(0, names.size())], vertices, draw_real(0.05, 0.4));
  for (Point& p : mesh.points) p += Point(p[1], p[2], p[0]) * 0.1234;
  for (int k = draw(0, 6); k > 0; --k)
    mesh.faces.erase(mesh.faces.begin() + draw<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(mesh.faces.size())));
  for (int k = draw(0, 4); k > 0; --k) mesh.faces.push_back(mesh.faces[draw<std::size_t>(0, mesh.faces.size())]);
  for (int k = draw(0, 4); k > 0; --k) {
    Triangle& turned = mesh.faces[draw<std::size_t>(0, mesh.faces.size())];
    std::swap(turned[0], turned[1]);
  }
  for (int k = draw(0, 3); k > 0; --k) mesh.points.push_back(mesh.points[0] * 1.1);
  return mesh;
}

/// A method with parameters, and how far its results may lie apart when the same numbers come rounded otherwise.
struct Draw {
  Method method;
  SmoothingParameters parameters;
  double tolerance;  ///< in |e|
  double share;      ///< of the vertices at which a yes or no inside the method may come out otherwise
};

Draw draw_method() {
  const vcg_core::MethodInfo& info = *rc::gen::elementOf(vcg_core::methods());
  Draw drawn{info.method, info.defaults, 1e-6, 0};
  const double fewest = info.find(&vcg_core::SmoothingParameters::iterations)->values.least;
  drawn.parameters.iterations = fewest == 0 ? draw(0, 3) : draw(1, 4);
  drawn.parameters.boundary = *rc::gen::element(vcg_core::Boundary::fixed, vcg_core::Boundary::free);
  if (info.method == Method::paper) {
    drawn.parameters.arithmetic = *rc::gen::element(vcg_core::Arithmetic::fast, vcg_core::Arithmetic::reference);
    drawn.tolerance = 1e-5;
  }
  if (info.uses(&vcg_core::SmoothingParameters::rho)) {
    drawn.parameters.sigma_c = draw_real(0.7, 2.5);
    // A distance next to the cut-off; what it changes at one vertex, later passes carry to those around.
    drawn.share = 0.02 * std::max(1, drawn.parameters.iterations * drawn.parameters.iterations);
  }
  if (info.method == Method::guided) {
    drawn.parameters.blend = *rc::gen::element(vcg_core::Blend::on, vcg_core::Blend::off);
    drawn.share = 0.05;      // two guides of the same consistency
    drawn.tolerance = 2e-3;  // candidates of the blend, which also looks for correlated noise, are packed to 7e-5
  }
  return drawn;
}

/// Compares a changed mesh's result, changed back, with that of the mesh itself.
template <class Back>
void expect_same(const Draw& drawn, const FlatMesh& mesh, const FlatMesh& changed, const Back& back,
                 double rounding = 0) {
  RC_LOG() << vcg_core::method_name(drawn.method) << ", " << mesh.points.size() << " vertices\n";
  RC_TAG(vcg_core::method_name(drawn.method));
  const FlatMesh expected = smoothed_by(drawn.method, mesh, drawn.parameters).mesh;
  const FlatMesh result = back(smoothed_by(drawn.method, changed, drawn.parameters).mesh);
  const double e = average_edge_length(mesh);
  const Difference d = difference(result, expected, drawn.tolerance * e + rounding);
  RC_LOG() << d.beyond_tolerance << " vertices differ, by up to " << d.largest / e << " |e| at " << d.at << "\n";
  RC_ASSERT(static_cast<double>(d.beyond_tolerance) <= drawn.share * static_cast<double>(mesh.points.size()));
}

RC_GTEST_PROP(InvarianceOfEveryMethod, OfTranslation, ()) {
  const Point shift(draw_real(-1e6, 1e6), draw_real(-1e6, 1e6), draw_real(-1e6, 1e6));
  const FlatMesh there = transformed(draw_mesh(), [&](const Point& p) { return p + shift; });
  const auto back = [&](const FlatMesh& mesh) { return transformed(mesh, [&](const Point& p) { return p - shift; }); };
  expect_same(draw_method(), back(there), there, back, 1e-8);
}

RC_GTEST_PROP(InvarianceOfEveryMethod, OfRotation, ()) {
  const FlatMesh mesh = draw_mesh();
  const Point axis(draw_real(-1, 1), draw_real(-1, 1), draw_real(0.1, 1));
  const double angle = draw_real(-3, 3);
  const auto turned = [&](const FlatMesh& m, double by) {
    vcg::Matrix44d rotation;
    rotation.SetRotateRad(by, axis);
    return transformed(m, [&](const Point& p) { return rotation * p; });
  };
  expect_same(draw_method(), mesh, turned(mesh, angle), [&](const FlatMesh& m) { return turned(m, -angle); });
}

RC_GTEST_PROP(InvarianceOfEveryMethod, OfScale, ()) {
  const FlatMesh mesh = draw_mesh();
  const double scale = std::pow(10, draw_real(-12, 12));
  expect_same(draw_method(), mesh, transformed(mesh, [&](const Point& p) { return p * scale; }),
              [&](const FlatMesh& m) { return transformed(m, [&](const Point& p) { return p / scale; }); });
}

RC_GTEST_PROP(InvarianceOfEveryMethod, OfTheOrderOfVerticesFacesAndCorners, ()) {
  const FlatMesh mesh = draw_mesh();
  const auto draw_order = [](std::size_t count) {
    std::vector<std::size_t> order(count);
    for (std::size_t k = 0; k < count; ++k) {
      order[k] = k;
      std::swap(order[k], order[draw<std::size_t>(0, k + 1)]);
    }
    return order;
  };
  const std::vector<std::size_t> place_of = draw_order(mesh.points.size());
  const std::vector<std::size_t> face_at = draw_order(mesh.faces.size());
  FlatMesh shuffled = mesh;
  for (std::size_t v = 0; v < place_of.size(); ++v) shuffled.points[place_of[v]] = mesh.points[v];
  for (std::size_t f = 0; f < face_at.size(); ++f) {
    shuffled.faces[f] = mesh.faces[face_at[f]];
    for (std::size_t& v : shuffled.faces[f]) v = place_of[v];
    std::rotate(shuffled.faces[f].begin(), shuffled.faces[f].begin() + draw(0, 3), shuffled.faces[f].end());
  }
  expect_same(draw_method(), mesh, shuffled, [&](FlatMesh result) {
    const FlatMesh there = result;
    for (std::size_t v = 0; v < place_of.size(); ++v) result.points[v] = there.points[place_of[v]];
    return result;
  });
}

RC_GTEST_PROP(InvarianceOfEveryMethod, OfTheSideThatAllFacesShow, ()) {
  const FlatMesh mesh = draw_mesh();
  FlatMesh turned = mesh;
  for (Triangle& f : turned.faces) std::swap(f[1], f[2]);
  expect_same(draw_method(), mesh, turned, [](const FlatMesh& m) { return m; });
}

RC_GTEST_PROP(InvarianceOfEveryMethod, OfTheNumberOfThreadsBitForBit, ()) {
  const FlatMesh mesh = draw_mesh();
  Draw drawn = draw_method();
  RC_TAG(vcg_core::method_name(drawn.method));
  drawn.parameters.threads = 1;
  const FlatMesh expected = smoothed_by(drawn.method, mesh, drawn.parameters).mesh;
  drawn.parameters.threads = draw(2, 9);
  RC_ASSERT(same_bits(smoothed_by(drawn.method, mesh, drawn.parameters).mesh, expected));
}

}  // namespace
