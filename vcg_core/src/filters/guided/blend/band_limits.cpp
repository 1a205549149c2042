// SPDX-License-Identifier: GPL-3.0-or-later
#include "band_limits.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "job.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;
constexpr double blur = 1.0 / 3;    ///< standard deviation of the step, in cut-offs
constexpr double window_end = 2.6;  ///< terms below exp(-2.6^2 / 2) = 0.03 are left out

}  // namespace

std::vector<double> band_limit_coefficients(double cut_off) {
  const double pi = std::acos(-1.0);
  const double sigma = blur * cut_off;
  std::vector<double> coefficient{cut_off / pi};
  double sum = coefficient.front();
  for (int n = 1; n * sigma <= window_end; ++n) {
    coefficient.push_back(2 * std::sin(n * cut_off) / (n * pi) * std::exp(-0.5 * n * sigma * n * sigma));
    sum += coefficient.back();
  }
  for (double& c : coefficient) c /= sum;
  return coefficient;
}

std::vector<Array<Vec3>> band_limited_positions(const MeshArrays& mesh, const RingMeans& rings,
                                                const Array<Vec3>& position, const std::vector<double>& cut_offs,
                                                Job& job) {
  std::optional<RingMeans> of_creases;
  if (!mesh.topology.on_crease.empty()) of_creases.emplace(mesh, job, AtCreases::the_two_along_them);
  const RingMeans& averaged = of_creases ? *of_creases : rings;
  std::vector<std::vector<double>> coefficients;
  std::size_t terms = 0;
  for (const double cut_off : cut_offs) {
    coefficients.push_back(band_limit_coefficients(cut_off));
    terms = std::max(terms, coefficients.back().size());
  }
  std::vector<Array<Vec3>> sum(cut_offs.size(), Array<Vec3>(position.size()));
  Array<Vec3> last(position.size());  // T_{n-1}
  Array<Vec3> current = position;     // T_n
  // T_1 = W T_0, T_{n+1} = 2 W T_n - T_{n-1}, written over T_{n-1}.
  const auto advance = [&](std::size_t n, const auto& use) {
    job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
          const Vec3 mean = averaged.mean(current, v);
          last[v] = n == 0 ? mean : Vec3(2 * mean - last[v]);
          use(v);
        }
    });
    last.swap(current);
  };
  // Two terms at a time: there are more sums than terms to read.
  for (std::size_t n = 0; n < terms; n += 2) {
    advance(n, [&](std::size_t v) {
      for (std::size_t k = 0; k < sum.size(); ++k) {
        const std::vector<double>& c = coefficients[k];
        if (n >= c.size()) continue;
        sum[k][v] = n == 0 ? Vec3(c[0] * current[v]) : Vec3(sum[k][v] + c[n] * current[v]);
        if (n + 1 < c.size()) sum[k][v] += c[n + 1] * last[v];
      }
    });
    if (n + 2 < terms) advance(n + 1, [](std::size_t) {});
  }
  return sum;
}

}  // namespace vcg_core::detail
