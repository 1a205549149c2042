#include <mesh_tools/noise.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <vcg/complex/algorithms/update/bounding.h>

#include <mesh_tools/random.h>

namespace mesh_tools {

std::vector<vcg::Point3d> vertex_normals(const Mesh& mesh) {
  std::vector<vcg::Point3d> normals(mesh.vert.size(), vcg::Point3d(0, 0, 0));
  for (const auto& face : mesh.face) {
    if (face.IsD()) continue;
    vcg::Point3d normal = (face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0));
    const double length = normal.Norm();
    if (!(length > 0)) continue;
    normal /= length;
    for (int k = 0; k < 3; ++k) {
      const vcg::Point3d a = face.cP((k + 1) % 3) - face.cP(k), b = face.cP((k + 2) % 3) - face.cP(k);
      normals[vcg::tri::Index(mesh, face.cV(k))] += normal * std::atan2((a ^ b).Norm(), a * b);
    }
  }
  for (vcg::Point3d& normal : normals) {
    const double length = normal.Norm();
    normal = length > 1e-12 ? normal / length : vcg::Point3d(0, 0, 0);
  }
  return normals;
}

void add_noise(Mesh& mesh, double level, std::uint64_t seed, NoiseDirection direction) {
  if (!(level >= 0) || !std::isfinite(level))
    throw std::invalid_argument("noise level is " + std::to_string(level) + "; it must be finite and at least 0");
  const double deviation = level * average_edge_length(mesh);
  const std::vector<vcg::Point3d> normals = vertex_normals(mesh);
  Random random(seed);
  for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
    auto& vertex = mesh.vert[i];
    if (vertex.IsD()) continue;
    const double distance = deviation * random.normal();
    vertex.P() += (direction == NoiseDirection::normal ? normals[i] : random.direction()) * distance;
  }
  vcg::tri::UpdateBounding<Mesh>::Box(mesh);
}

}  // namespace mesh_tools
