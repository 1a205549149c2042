// SPDX-License-Identifier: GPL-3.0-or-later
#include "core_case.h"

namespace fuzz {
namespace {

enum Flag : std::uint8_t {
  boundary_free = 1,
  selected_only = 2,
  printed = 4,
  reference = 8,
  smooth_color = 16,
  wide = 32  // double precision
};

}  // namespace

CoreCase CoreCase::decode(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  CoreCase result;
  const auto& methods = vcg_core::methods();
  result.method = methods[bytes.take<std::uint8_t>() % methods.size()].method;
  const auto flags = bytes.take<std::uint8_t>();
  result.double_precision = flags & wide;
  result.cancel_at = bytes.take<std::uint8_t>();
  vcg_core::SmoothingParameters& parameters = result.parameters;
  parameters.iterations = bytes.take<std::int8_t>() % 4;  // more passes only take longer
  parameters.boundary = flags & boundary_free ? vcg_core::Boundary::free : vcg_core::Boundary::fixed;
  parameters.selected_only = flags & selected_only;
  parameters.gaussian = flags & printed ? vcg_core::GaussianForm::printed : vcg_core::GaussianForm::standard_deviation;
  parameters.arithmetic = flags & reference ? vcg_core::Arithmetic::reference : vcg_core::Arithmetic::fast;
  parameters.smooth_color = flags & smooth_color;
  for (double* value : {&parameters.sigma_c, &parameters.sigma_s, &parameters.sigma_n, &parameters.rho,
                        &parameters.strength, &parameters.feature_angle})
    *value = bytes.take<double>();
  result.vertices.resize(bytes.take<std::uint8_t>());
  result.faces.resize(bytes.take<std::uint8_t>());
  for (Face& face : result.faces) {
    for (std::uint8_t& corner : face.corner) corner = bytes.take<std::uint8_t>();
    face.flags = bytes.take<std::uint8_t>();
  }
  for (Vertex& vertex : result.vertices) {
    for (float* coordinate : {&vertex.x, &vertex.y, &vertex.z}) *coordinate = bytes.take<float>();
    vertex.flags = bytes.take<std::uint8_t>();
  }
  return result;
}

std::string CoreCase::encode() const {
  ByteWriter bytes;
  bytes.put(static_cast<std::uint8_t>(method));
  const int flags = (parameters.boundary == vcg_core::Boundary::free ? boundary_free : 0) |
                    (parameters.selected_only ? selected_only : 0) |
                    (parameters.gaussian == vcg_core::GaussianForm::printed ? printed : 0) |
                    (parameters.arithmetic == vcg_core::Arithmetic::reference ? reference : 0) |
                    (parameters.smooth_color ? smooth_color : 0) | (double_precision ? wide : 0);
  bytes.put(static_cast<std::uint8_t>(flags));
  bytes.put(cancel_at);
  bytes.put(static_cast<std::int8_t>(parameters.iterations));
  for (const double value : {parameters.sigma_c, parameters.sigma_s, parameters.sigma_n, parameters.rho,
                             parameters.strength, parameters.feature_angle})
    bytes.put(value);
  bytes.put(static_cast<std::uint8_t>(vertices.size()));
  bytes.put(static_cast<std::uint8_t>(faces.size()));
  for (const Face& face : faces) {
    for (const std::uint8_t corner : face.corner) bytes.put(corner);
    bytes.put(face.flags);
  }
  for (const Vertex& vertex : vertices) {
    for (const float coordinate : {vertex.x, vertex.y, vertex.z}) bytes.put(coordinate);
    bytes.put(vertex.flags);
  }
  return bytes.bytes();
}

}  // namespace fuzz
