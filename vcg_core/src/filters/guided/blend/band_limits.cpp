// SPDX-License-Identifier: GPL-3.0-or-later
#include "band_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <vcg_core/detail/job.h>

#include "../ring_mean.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;
constexpr double blur = 1.0 / 3;    ///< standard deviation of the step, in cut-offs
constexpr double window_end = 2.6;  ///< terms below exp(-2.6^2 / 2) = 0.03 are left out

/// The neighbours of v along the creases at v, if there are exactly two; else v itself twice.
std::array<Index, 2> crease_neighbours(const MeshArrays& mesh, Index v) {
  const MeshTopology& topology = mesh.topology;
  const std::array<Index, 2> none{v, v};
  std::array<Index, 2> found = none;
  std::size_t count = 0;
  for (Index s = topology.star_begin[v]; s < topology.star_begin[v + 1]; ++s)
    for (const auto& [end, opposite] :
         {std::pair{next_in_face(topology.star[s]), previous_in_face(topology.star[s])},
          std::pair{previous_in_face(topology.star[s]), next_in_face(topology.star[s])}}) {
      const Index u = vertex_of(mesh, end);
      if (!topology.crease[opposite] || u == found[0] || u == found[1]) continue;
      if (count == 2) return none;
      found[count++] = u;
    }
  return count == 2 ? found : none;
}

Vec3 mean_at(const MeshArrays& mesh, const Array<Vec3>& value, Index v) {
  if (mesh.topology.star_begin[v] == mesh.topology.star_begin[v + 1]) return value[v];
  if (!mesh.topology.is_on_crease(v)) return ring_mean(mesh, value, v);
  const auto [a, b] = crease_neighbours(mesh, v);
  return 0.5 * (value[a] + value[b]);
}

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

std::vector<Array<Vec3>> band_limited_positions(const MeshArrays& mesh, const Array<Vec3>& position,
                                                const std::vector<double>& cut_offs, Job& job) {
  std::vector<std::vector<double>> coefficients;
  std::size_t terms = 0;
  for (const double cut_off : cut_offs) {
    coefficients.push_back(band_limit_coefficients(cut_off));
    terms = std::max(terms, coefficients.back().size());
  }
  std::vector<Array<Vec3>> sum(cut_offs.size(), Array<Vec3>(position.size()));
  Array<Vec3> last(position.size());  // T_{n-1}
  Array<Vec3> current = position;     // T_n
  for (std::size_t n = 0; n < terms; ++n) {
    job.parallel(mesh.size(), grain, Loop::minor, [&](Chunks& chunks) {
      while (chunks.next())
        for (auto v = static_cast<Index>(chunks.begin()); v < chunks.end(); ++v) {
          for (std::size_t k = 0; k < sum.size(); ++k) {
            if (n == 0)
              sum[k][v] = coefficients[k][0] * current[v];
            else if (n < coefficients[k].size())
              sum[k][v] += coefficients[k][n] * current[v];
          }
          if (n + 1 == terms) continue;
          const Vec3 mean = mean_at(mesh, current, v);
          // T_1 = W T_0, T_{n+1} = 2 W T_n - T_{n-1}, written over T_{n-1}.
          last[v] = n == 0 ? mean : Vec3(2 * mean - last[v]);
        }
    });
    last.swap(current);
  }
  return sum;
}

}  // namespace vcg_core::detail
