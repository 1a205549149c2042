// SPDX-License-Identifier: GPL-3.0-or-later
#include "band_limits.h"

#include <algorithm>
#include <cmath>

#include "../ring_means.h"
#include "job.h"
#include "polled_copy.h"

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

std::vector<Array<Eigen::Vector3f>> band_limit_displacements(const MeshArrays& mesh, const Array<Vec3>& position,
                                                             const std::vector<double>& cut_offs, Job& job) {
  const RingMeans rings(mesh, job, AtCreases::the_two_along_them);
  std::vector<std::vector<double>> coefficients;
  std::size_t terms = 0;
  for (const double cut_off : cut_offs) {
    coefficients.push_back(band_limit_coefficients(cut_off));
    terms = std::max(terms, coefficients.back().size());
  }
  // The coefficients add up to 1, so the displacement is the sum of those of the terms.
  std::vector<Array<Eigen::Vector3f>> sum(cut_offs.size());
  for (Array<Eigen::Vector3f>& one : sum) one.resize(position.size());  // the first terms set them
  Array<Vec3> last(position.size());                                    // T_{n-1}
  Array<Vec3> current = polled_copy(position, job);                     // T_n
  // T_1 = W T_0, T_{n+1} = 2 W T_n - T_{n-1}, written over T_{n-1}.
  const auto advance = [&](std::size_t n, const auto& use) {
    job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (std::size_t v = chunks.begin(); v < chunks.end(); ++v) {
          const Vec3 mean = rings.mean(current, v);
          last[v] = n == 0 ? mean : Vec3(2 * mean - last[v]);
          use(v);
        }
    });
    last.swap(current);
  };
  // Two terms at a time: there are more sums than terms to read.
  for (std::size_t n = 0; n < terms; n += 2) {
    advance(n, [&](std::size_t v) {
      const Vec3 of_term = current[v] - position[v], of_next = last[v] - position[v];
      for (std::size_t k = 0; k < sum.size(); ++k) {
        const std::vector<double>& c = coefficients[k];
        if (n >= c.size()) continue;
        Vec3 step = c[n] * of_term;
        if (n + 1 < c.size()) step += c[n + 1] * of_next;
        if (n == 0) sum[k][v].setZero();
        sum[k][v] += step.cast<float>();
      }
    });
    if (n + 2 < terms) advance(n + 1, [](std::size_t) {});
  }
  return sum;
}

}  // namespace vcg_core::detail
