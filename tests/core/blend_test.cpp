// SPDX-License-Identifier: GPL-3.0-or-later
// The learned blend of the guided filter: its low-passes and networks against naive references, and what a blend must
// keep whatever its weights are.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <job.h>
#include <mesh_tools/random.h>
#include <support/arrays_of.h>
#include <support/noisy_shapes.h>
#include <support/unpacked.h>

#include "filters/guided/blend/band_limits.h"
#include "filters/guided/blend/blend.h"
#include "filters/guided/blend/blend_network.h"
#include "filters/guided/blend/blend_weights.h"
#include "filters/guided/blend/layer_kernels.h"
#include "filters/guided/coarse_rounds.h"
#include "filters/guided/four_normals.h"
#include "filters/guided/ring_means.h"
#include "mesh/creases.h"

namespace {

using namespace vcg_core::detail;
using test_support::arrays_of;
using test_support::FlatMesh;

const vcg_core::Progress no_progress;

/// T_n(x) by its definition.
double chebyshev(std::size_t n, double x) { return std::cos(static_cast<double>(n) * std::acos(x)); }

double response(double cut_off, double theta) {
  const std::vector<double> coefficient = band_limit_coefficients(cut_off);
  double sum = 0;
  for (std::size_t n = 0; n < coefficient.size(); ++n) sum += coefficient[n] * chebyshev(n, std::cos(theta));
  return sum;
}

TEST(BandLimits, KeepLongWavesAndNoShortOnes) {
  for (const double cut_off : {1.4, 0.65, 0.25, 0.125}) {
    EXPECT_NEAR(response(cut_off, 0), 1, 1e-12);
    EXPECT_NEAR(response(cut_off, 0.3 * cut_off), 1, 0.05);
    EXPECT_NEAR(response(cut_off, cut_off), 0.5, 0.03);
    for (double theta = 2 * cut_off; theta < 3.14; theta += 0.01) EXPECT_NEAR(response(cut_off, theta), 0, 0.03);
  }
}

/// The matrix of means over the one ring, inner edges twice.
Eigen::MatrixXd ring_matrix(const MeshArrays& mesh) {
  const auto size = static_cast<Eigen::Index>(mesh.size());
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(size, size);
  for (const auto& f : mesh.face)
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) w(f[k], f[other]) += 1;
  for (Eigen::Index v = 0; v < size; ++v) w.row(v) /= w.row(v).sum();
  return w;
}

Eigen::MatrixXd in_rows(const Array<Vec3>& position) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(position.size()), 3);
  for (std::size_t v = 0; v < position.size(); ++v) rows.row(static_cast<Eigen::Index>(v)) = position[v];
  return rows;
}

/// Closed, with borders, and a soup of faces that meet in any number at an edge, some turned the other way.
std::vector<FlatMesh> meshes_of_all_kinds() {
  FlatMesh soup;
  mesh_tools::Random random(3);
  for (int v = 0; v < 9; ++v) soup.points.emplace_back(random.uniform(), random.uniform(), random.uniform());
  const auto any = [&] { return static_cast<std::size_t>(8 * random.uniform()); };
  for (std::size_t a = 0; a < 8; ++a)
    for (int k = 0; k < 3; ++k) {
      const std::size_t b = (a + 1 + any() % 3) % 8;
      soup.faces.push_back({a, b, (b + 1 + any() % 4) % 8});
      if (soup.faces.back()[2] == a) soup.faces.pop_back();
    }
  return {test_support::noisy_shape("torus", 300), test_support::noisy_shape("plane_delaunay", 200), soup};
}

TEST(RingMeans, CountANeighbourOnceForEachFace) {
  for (const FlatMesh& shape : meshes_of_all_kinds()) {
    Job job(no_progress, 2);
    const MeshArrays mesh = arrays_of(shape, job);
    const RingMeans rings(mesh, job);
    ASSERT_EQ(rings.size(), mesh.size());
    const Eigen::MatrixXd mean = ring_matrix(mesh) * in_rows(mesh.position);
    for (std::size_t v = 0; v < mesh.size(); ++v) {
      const bool alone = mesh.topology.star_begin[v] == mesh.topology.star_begin[v + 1];
      const Vec3 expected = alone ? mesh.position[v] : Vec3(mean.row(static_cast<Eigen::Index>(v)));
      EXPECT_LT((rings.mean(mesh.position, v) - expected).norm(), 1e-12) << v;
    }
  }
}

Array<Vec3> displaced(Array<Vec3> position, const Array<Eigen::Vector3f>& displacement) {
  for (std::size_t v = 0; v < position.size(); ++v) position[v] += displacement[v].cast<double>();
  return position;
}

double largest_of(const Array<Eigen::Vector3f>& displacement) {
  float largest = 0;
  for (const Eigen::Vector3f& d : displacement) largest = std::max(largest, d.norm());
  return largest;
}

TEST(BandLimits, AreChebyshevPolynomialsInTheRingMean) {
  Job job(no_progress, 2);
  const MeshArrays mesh = arrays_of(test_support::noisy_shape("torus", 300), job);
  const std::vector<double> cut_offs{1.0, 0.4};
  const std::vector<Array<Eigen::Vector3f>> low = band_limit_displacements(mesh, mesh.position, cut_offs, job);
  const Eigen::MatrixXd w = ring_matrix(mesh);
  const Eigen::MatrixXd x = in_rows(mesh.position);
  for (std::size_t k = 0; k < cut_offs.size(); ++k) {
    const std::vector<double> c = band_limit_coefficients(cut_offs[k]);
    Eigen::MatrixXd before = x, current = w * x, sum = c[0] * before + c[1] * current;
    for (std::size_t n = 2; n < c.size(); ++n) {
      const Eigen::MatrixXd next = 2 * w * current - before;
      before = current;
      current = next;
      sum += c[n] * current;
    }
    // Displacements are in single precision.
    EXPECT_LT((in_rows(displaced(mesh.position, low[k])) - sum).cwiseAbs().maxCoeff(), 3e-7 * largest_of(low[k]));
  }
}

TEST(BandLimits, LeaveStraightCreasesStraight) {
  Job job(no_progress, 1);
  // A roof: ridge vertices 0 to 8 on the x axis, eaves on both sides.
  FlatMesh roof;
  for (int i = 0; i < 9; ++i) roof.points.emplace_back(i + 0.3 * (i % 2), 0, 0);
  for (const int side : {-1, 1})
    for (int i = 0; i < 9; ++i) roof.points.emplace_back(i, side, -0.8);
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t a = i, b = i + 1, c = 9 + 9 * side + i, d = c + 1;
      if (side == 0) {
        roof.faces.push_back({a, c, d});
        roof.faces.push_back({a, d, b});
      } else {
        roof.faces.push_back({a, d, c});
        roof.faces.push_back({a, b, d});
      }
    }
  MeshArrays mesh = arrays_of(roof, job);
  const Array<Index> place = vertex_of_host(mesh);
  Array<std::array<Index, 2>> ridge;
  for (std::size_t i = 0; i < 8; ++i) ridge.push_back({place[i], place[i + 1]});
  const Array<Vec3> blunt = displaced(mesh.position, band_limit_displacements(mesh, mesh.position, {0.8}, job)[0]);
  find_creases(mesh, ridge, job);
  const Array<Vec3> sharp = displaced(mesh.position, band_limit_displacements(mesh, mesh.position, {0.8}, job)[0]);
  EXPECT_LT(blunt[place[4]][2], -0.05);  // without creases the ridge sinks
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(sharp[place[i]][1], 0, 1e-12);
    EXPECT_NEAR(sharp[place[i]][2], 0, 1e-12);
  }
  EXPECT_NEAR((sharp[place[0]] - mesh.position[place[0]]).norm(), 0, 1e-12);  // where the crease ends
}

/// Candidates and a table of random numbers, small enough for a reference by hand.
struct RandomCase {
  RandomCase() {
    mesh_tools::Random random(5);
    const auto unit = [&] {
      const vcg::Point3d d = random.direction();
      return packed(in_single(Vec3(d[0], d[1], d[2])));
    };
    for (int c = 0; c < 4; ++c) {
      candidates.normal.emplace_back();
      for (int f = 0; f < 37; ++f) candidates.normal.back().push_back(unit());
    }
    candidates.scalar.emplace_back();
    for (int f = 0; f < 37; ++f) candidates.scalar.back().emplace_back(static_cast<float>(random.uniform()));
    value.resize(values_in(sizes));
    for (std::int16_t& v : value) v = static_cast<std::int16_t>(4096 * random.normal());
    for (std::size_t i = 0; i < sizes[0]; ++i) value[sizes[0] + i] = static_cast<std::int16_t>(2000 + 10 * i);
  }

  NetworkTable table() const { return {{sizes[0], sizes[1], sizes[2], sizes[3]}, value.data(), value.size()}; }

  Vec3 normal(std::size_t candidate, std::size_t face) const {
    return test_support::unpacked(candidates.normal[candidate][face]);
  }

  static constexpr std::size_t sizes[] = {7, 5, 3, 4};
  Candidates candidates;
  std::vector<std::int16_t> value;
};

TEST(PackedNormal, IsTheNormalAsFarAsItsBitsReach) {
  mesh_tools::Random random(8);
  for (int i = 0; i < 10000; ++i) {
    const vcg::Point3d d = random.direction();
    const Vec3 n(d[0], d[1], d[2]);
    const Vec3 result = test_support::unpacked(packed(in_single(n)));
    EXPECT_LT((result - n).norm(), 7e-5) << n.transpose();
    EXPECT_NEAR(result.norm(), 1, 2e-7);
    EXPECT_EQ(test_support::unpacked(packed(in_single(result))), result);  // packing again changes nothing
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 unit = sign * Vec3::Unit(axis);
      for (const double length : {1.0, 1.0000002}) {
        const Vec3 result = test_support::unpacked(packed(in_single(Vec3(length * unit))));
        EXPECT_EQ(Vec3(result / result.norm()), unit);
        EXPECT_NEAR(result.norm(), 1, 2e-7);
      }
    }
  EXPECT_EQ(test_support::unpacked(PackedNormal()), Vec3(Vec3::Zero()));
  EXPECT_EQ(test_support::unpacked(packed(UnitNormal::Zero())), Vec3(Vec3::Zero()));
}

TEST(PackedNormal, UnpacksAnyNumberAtOnce) {
  mesh_tools::Random random(9);
  Array<PackedNormal> packed(11);
  for (std::size_t i = 1; i < packed.size(); ++i) {
    const vcg::Point3d d = random.direction();
    packed[i] = vcg_core::detail::packed(in_single(Vec3(d[0], d[1], d[2])));
  }
  for (std::size_t count = 0; count <= packed.size(); ++count) {
    Array<UnitNormal> unit(count + 1, UnitNormal::Constant(7));
    unpack(packed.data(), count, unit.data());
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(in_double(unit[i]), test_support::unpacked(packed[i])) << i << " of " << count;
      EXPECT_EQ(unit[i][3], 0);
    }
    EXPECT_EQ(unit[count], UnitNormal(UnitNormal::Constant(7)));
  }
}

TEST(PackedNormal, IsPackedFourAtATimeAlike) {
  mesh_tools::Random random(10);
  for (int i = 0; i < 1000; ++i) {
    UnitNormal normal[4];
    PackedNormal packed[4];
    for (UnitNormal& n : normal) {
      const vcg::Point3d d = random.direction();
      n = in_single(Vec3(d[0], d[1], d[2]));
    }
    normal[i % 4] = i % 3 == 0 ? UnitNormal(UnitNormal::Zero()) : UnitNormal(-UnitNormal::Unit(i % 3));
    const auto coordinate = [&](int k) {
      return FourFloats(quad::set(normal[0][k], normal[1][k], normal[2][k], normal[3][k]));
    };
    pack({coordinate(0), coordinate(1), coordinate(2)}, packed);
    for (int k = 0; k < 4; ++k)
      EXPECT_EQ(test_support::unpacked(packed[k]), test_support::unpacked(vcg_core::detail::packed(normal[k])))
          << normal[k].transpose();
  }
}

TEST(PackedNumber, IsTheNumberAsFarAsItsBitsReach) {
  for (float x = 0; x < 3.99F; x += 0.001F) EXPECT_NEAR(PackedNumber(x).value(), x, 3.1e-5) << x;
  for (const float x : {4.0F, 1e30F, std::numeric_limits<float>::infinity()})
    EXPECT_NEAR(PackedNumber(x).value(), 4, 1e-4) << x;
  EXPECT_EQ(PackedNumber().value(), 0);
  EXPECT_EQ(PackedNumber(1).value(), 1);
}

TEST(BlendNetwork, IsThatOfItsTable) {
  Job job(no_progress, 2);
  const RandomCase c;
  const Array<UnitNormal> blended = BlendNetwork(c.table()).blend(c.candidates, job);
  for (std::size_t f = 0; f < 37; ++f) {
    std::vector<double> x;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) x.push_back((c.normal(a, f) - c.normal(b, f)).norm());
    x.push_back(c.candidates.scalar[0][f].value());
    const std::int16_t* next = c.value.data();
    for (double& input : x) input -= *next++ / 4096.0;
    for (double& input : x) input /= *next++ / 4096.0;
    for (int layer = 0; layer < 3; ++layer) {
      std::vector<double> y(c.sizes[layer + 1], 0.0);
      for (double& sum : y)
        for (const double input : x) sum += *next++ / 4096.0 * input;
      for (double& sum : y) sum += *next++ / 4096.0;
      if (layer < 2)
        for (double& sum : y) sum = sum > 0 ? sum : sum / 10;
      x = y;
    }
    Vec3 sum = Vec3::Zero();
    for (std::size_t a = 0; a < 4; ++a) sum += x[a] * c.normal(a, f);
    EXPECT_LT((in_double(blended[f]) - sum.normalized()).norm(), 1e-4 / std::min(1.0, sum.norm())) << f;
  }
}

/// Outputs that fill the widest kernel's vectors, and some that are left over.
TEST(LayerKernels, AllGiveTheBitsOfTheFormula) {
  constexpr std::size_t inputs = 29;
  for (const std::size_t outputs : {1, 7, 8, 14, 40})
    for (const bool rectify : {false, true}) {
      mesh_tools::Random random(outputs);
      const auto normal = [&] { return static_cast<float>(random.normal()); };
      std::vector<float> matrix(inputs * outputs), offset(outputs);
      std::generate(matrix.begin(), matrix.end(), normal);
      std::generate(offset.begin(), offset.end(), normal);
      std::vector<BlockRow> in(inputs), out(outputs);
      for (BlockRow& row : in) std::generate(std::begin(row.lane), std::end(row.lane), normal);
      for (const LayerKernel* kernel : supported_layer_kernels()) {
        kernel->apply({inputs, outputs, matrix.data(), offset.data(), rectify}, in.data(), out.data());
        for (std::size_t o = 0; o < outputs; ++o)
          for (std::size_t lane = 0; lane < block; ++lane) {
            float sum = offset[o];
            for (std::size_t i = 0; i < inputs; ++i) {
              const float product = matrix[o * inputs + i] * in[i].lane[lane];
              sum += product;
            }
            ASSERT_EQ(out[o].lane[lane], rectify && sum < 0 ? sum * 0.1F : sum) << kernel->name;
          }
      }
    }
}

TEST(BlendNetwork, TakesTheSafeCandidateWhereTheSumIsShort) {
  Job job(no_progress, 1);
  RandomCase c;
  std::fill(c.value.begin() + 2 * 7, c.value.end(), std::int16_t(0));
  const Array<UnitNormal> blended = BlendNetwork(c.table()).blend(c.candidates, job);
  for (std::size_t f = 0; f < 37; ++f) EXPECT_EQ(in_double(blended[f]), c.normal(safe_candidate, f)) << f;
}

std::vector<NetworkTable> all_tables() {
  return {white_noise_weights().first, white_noise_weights().second, correlated_noise_weights().first,
          correlated_noise_weights().second};
}

TEST(BlendTable, ShowsDamage) {
  RandomCase c;
  const std::uint32_t whole = checksum(c.value.data(), c.value.size());
  c.value[20] ^= 1;
  EXPECT_NE(checksum(c.value.data(), c.value.size()), whole);
  c.value[20] ^= 1;
  std::swap(c.value[20], c.value[21]);
  EXPECT_NE(checksum(c.value.data(), c.value.size()), whole);
  EXPECT_NE(checksum(c.value.data(), c.value.size() - 1), whole);
  for (const NetworkTable& table : all_tables()) EXPECT_EQ(table.count, values_in(table.sizes));
}

/// The coarse rounds of a mesh whose vertices may all move.
struct Coarse {
  Coarse(const MeshArrays& mesh, Job& job)
      : movable(mesh.size(), 1), input{mesh, mesh.position, no_normals, movable, job}, rounds(input, settings) {
    rounds.run();
  }

  Array<std::uint8_t> movable;
  Array<Vec3> no_normals;
  GuidedSettings settings;
  PassInput input;
  CoarseRounds rounds;
};

Array<UnitNormal> blended(const MeshArrays& mesh, Job& job) {
  job.begin_stage("", 1);
  Coarse coarse(mesh, job);
  CoarseResult result = coarse.rounds.take_result();
  return blended_normals(result, job);
}

TEST(Blend, NetworksFitTheCandidates) {
  Job job(no_progress, 2);
  job.begin_stage("", 1);
  const MeshArrays mesh = arrays_of(test_support::noisy_shape("cube", 400), job);
  Coarse coarse(mesh, job);
  CoarseResult result = coarse.rounds.take_result();
  const auto fits = [](const Candidates& candidates, const NetworkTable& table) {
    EXPECT_EQ(candidates.size(), table.sizes[NetworkTable::layers]);
    EXPECT_EQ(input_count(candidates.size(), candidates.scalar.size()), table.sizes[0]);
  };
  const Candidates first = first_candidates(result, job);
  const Candidates second = second_candidates(result, Array<UnitNormal>(mesh.face.size(), UnitNormal::UnitX()), job);
  for (const BlendWeights* weights : {&white_noise_weights(), &correlated_noise_weights()}) {
    fits(first, weights->first);
    fits(second, weights->second);
  }
}

TEST(Blend, TurnsWithTheMesh) {
  Job job(no_progress, 2);
  const FlatMesh flat = test_support::noisy_shape("cad_part", 1200, 0.2);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  MeshArrays mesh = arrays_of(flat, job);
  const Array<UnitNormal> normal = blended(mesh, job);
  for (Vec3& p : mesh.position) p = turn * p;
  const Array<UnitNormal> turned = blended(mesh, job);
  std::size_t different = 0;
  for (std::size_t f = 0; f < normal.size(); ++f)
    different += (in_double(turned[f]) - turn * in_double(normal[f])).norm() > 1e-3;
  EXPECT_LE(different, normal.size() / 200);  // where two guides are equally good, either may be taken
}

TEST(Blend, IsTheSameForAnyNumberOfThreads) {
  Job one(no_progress, 1), four(no_progress, 4);
  const MeshArrays mesh = arrays_of(test_support::noisy_shape("torus", 3000, 0.3), one);
  EXPECT_EQ(blended(mesh, one), blended(mesh, four));
}

TEST(Blend, LeavesAPlaneAsItIs) {
  Job job(no_progress, 1);
  Candidates candidates;
  for (const NetworkTable& table : all_tables()) {
    const PackedNormal packed = vcg_core::detail::packed(in_single(Vec3(0.6, 0, 0.8)));
    const Vec3 n = test_support::unpacked(packed);
    candidates.normal.assign(table.sizes[3], Array<PackedNormal>(20, packed));
    const std::size_t pairs = table.sizes[3] * (table.sizes[3] - 1) / 2;
    for (const float noise : {0.0F, 0.3F, 0.6F}) {
      candidates.scalar.assign(table.sizes[0] - pairs, Array<PackedNumber>(20, PackedNumber(noise)));
      for (const UnitNormal& normal : BlendNetwork(table).blend(candidates, job))
        EXPECT_LT((in_double(normal) - n).norm(), 1e-6);
    }
  }
}

}  // namespace
