// SPDX-License-Identifier: GPL-3.0-or-later
#include "normal_filter.h"

#include <algorithm>
#include <vector>

#include "face_geometry.h"
#include "four_normals.h"
#include "job.h"
#include "range_weight.h"
#include "unit_normals.h"

namespace vcg_core::detail {

namespace {

/// Blocks of faces.
constexpr std::size_t grain = 4;

/// Sums of normals that are shorter, as a share of their weights, have no direction: they cancel each other.
constexpr float no_direction = 1e-5F;

/// In 65535ths of the largest, rounded down. Where all faces are so tiny that this has no meaning, 0.
void write_shares(const std::vector<float>& weight, std::uint16_t* share) {
  constexpr float least = 1e-30F;
  const float largest = *std::max_element(weight.begin(), weight.end());
  const float scale = largest > least ? 65535 / largest : 0;
  for (std::size_t k = 0; k < weight.size(); ++k) share[k] = static_cast<std::uint16_t>(weight[k] * scale);
}

}  // namespace

ListWeights closeness_weights(const FaceLists& within, const MeshArrays& mesh, const Array<Vec3>& position,
                              const Array<double>& area, const Array<double>& spacing, double closeness, Job& job) {
  const RangeWeight<float> close(closeness);  // of distances in spacings
  ListWeights weight(within.entries());
  job.parallel(within.blocks(), grain, Loop::minor, [&](Chunks& chunks) {
    std::vector<Vec3> centroid;
    std::vector<double> areas;
    std::vector<float> of_list;
    while (chunks.next())
      for (std::size_t b = chunks.begin(); b < chunks.end(); ++b) {
        const FaceLists::Block& block = within.block(b);
        gather(block, centroid, [&](std::size_t f) { return centroid_of(mesh, position, f); });
        gather(block, areas, [&](std::size_t f) { return area[f]; });
        for_each_list(block, [&](std::size_t i, std::size_t first, std::size_t length) {
          const double s = spacing[block.first + i];
          const double unit = 1 / (s * s);  // areas as multiples of it neither over- nor underflow
          const std::uint16_t* const entry = block.entry.data() + first;
          of_list.resize(length);
          // Two loops, as compilers turn the second one into vectors.
          for (std::size_t k = 0; k < length; ++k)
            of_list[k] = static_cast<float>((centroid[entry[k]] - centroid[i]).squaredNorm() * unit);
          for (std::size_t k = 0; k < length; ++k)
            of_list[k] = static_cast<float>(areas[entry[k]] * unit) * close(of_list[k]);
          write_shares(of_list, weight.data() + block.first_entry + first);
        });
      }
  });
  return weight;
}

namespace {

FourNormals four_normals(const std::vector<UnitNormal>& normal, const std::uint16_t* place) {
  const auto load = [&](int k) { return FourFloats::at(normal[place[k]].data()); };
  FourFloats a = load(0), b = load(1), c = load(2), d = load(3);
  transpose(a, b, c, d);
  return {a, b, c};
}

/// A weighted sum of normals, four terms at a time.
class NormalSum {
 public:
  void add(FourFloats weight, const FourNormals& normal) {
    x_ += weight * normal.x;
    y_ += weight * normal.y;
    z_ += weight * normal.z;
    total_ += weight;
  }

  /// The sum, and as its fourth number that of the weights.
  void store(UnitNormal& sum) const {
    FourFloats x = x_, y = y_, z = z_, total = total_;
    transpose(x, y, z, total);
    (x + y + (z + total)).store(sum.data());
  }

 private:
  FourFloats x_ = 0, y_ = 0, z_ = 0, total_ = 0;
};

/// A list of neighbours by their places, with their weights.
struct List {
  const std::uint16_t* place;
  const float* weight;
  std::size_t length;
};

/// Calls body(places, weights) for the neighbours of a face, four at a time; at the end some have no weight.
template <class Body>
void visit_by_fours(const List& list, const Body& body) {
  const auto [place, weight, length] = list;
  std::size_t k = 0;
  for (; k + 4 <= length; k += 4) body(place + k, quad::set(weight[k], weight[k + 1], weight[k + 2], weight[k + 3]));
  if (k == length) return;
  std::uint16_t last_place[4];
  float last_weight[4];
  for (std::size_t i = 0; i < 4; ++i) {
    last_place[i] = place[std::min(k + i, length - 1)];
    last_weight[i] = k + i < length ? weight[k + i] : 0;
  }
  body(last_place, quad::set(last_weight[0], last_weight[1], last_weight[2], last_weight[3]));
}

void gather_normals(const FaceLists::Block& block, const Array<UnitNormal>& normal, std::vector<UnitNormal>& gathered) {
  gather(block, gathered, [&](std::size_t f) { return normal[f]; });
}

void gather_normals(const FaceLists::Block& block, const Array<PackedNormal>& normal,
                    std::vector<UnitNormal>& gathered) {
  const std::size_t own = block.length.size();
  gathered.resize(block.numbers());
  unpack(normal.data() + block.first, own, gathered.data());
  for (std::size_t i = 0; i < block.far.size(); i += 4) {
    PackedNormal four[4];
    const std::size_t count = std::min<std::size_t>(4, block.far.size() - i);
    for (std::size_t k = 0; k < count; ++k) four[k] = normal[block.far[i + k]];
    unpack(four, count, gathered.data() + own + i);
  }
}

/// The directions of four sums as NormalSum stores them; where they have none, the normals.
FourNormals directions(const UnitNormal* sums, const UnitNormal* normals) {
  const auto rows = [](const UnitNormal* four, FourFloats(&row)[4]) {
    for (int k = 0; k < 4; ++k) row[k] = FourFloats::at(four[k].data());
    transpose(row[0], row[1], row[2], row[3]);
  };
  FourFloats sum[4], normal[4];
  rows(sums, sum);
  rows(normals, normal);
  const FourFloats length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  const QuadMask has_direction = less(FourFloats(no_direction) * sum[3], length);
  return {where(has_direction, sum[0] / length, normal[0]), where(has_direction, sum[1] / length, normal[1]),
          where(has_direction, sum[2] / length, normal[2])};
}

void store(const FourNormals& normals, PackedNormal (&packed)[4]) { pack(normals, packed); }

/// Gives each normal the direction of a sum over its list.
/// @param begin_block  called with each block and its normals; gives sum_of(i, list) of the block's i-th face
template <class Normal, class BeginBlock>
Array<Normal> filter_each(const FaceLists& within, const ListWeights& weight, const Array<Normal>& normal, Job& job,
                          const BeginBlock& begin_block) {
  Array<Normal> filtered(normal.size());
  job.parallel(within.blocks(), grain, Loop::minor, [&](Chunks& chunks) {
    std::vector<UnitNormal> normals, guides;
    std::vector<float> weights;
    std::vector<UnitNormal> sums(FaceLists::block_size, UnitNormal::Zero());
    Normal four[4];
    while (chunks.next())
      for (std::size_t b = chunks.begin(); b < chunks.end(); ++b) {
        const FaceLists::Block& block = within.block(b);
        gather_normals(block, normal, normals);
        const auto sum_of = begin_block(block, normals, guides);
        const std::uint16_t* const shares = weight.data() + block.first_entry;
        weights.resize(block.entry.size());
        for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = static_cast<float>(shares[k]);
        for_each_list(block, [&](std::size_t i, std::size_t first, std::size_t length) {
          sum_of(i, List{block.entry.data() + first, weights.data() + first, length}).store(sums[i]);
        });
        const std::size_t count = block.length.size();
        normals.resize(std::max(normals.size(), FaceLists::block_size),
                       UnitNormal::Zero());  // so that four can be read
        for (std::size_t i = 0; i < count; i += 4) {
          store(directions(&sums[i], &normals[i]), four);
          std::copy_n(four, std::min<std::size_t>(4, count - i),
                      filtered.begin() + static_cast<std::ptrdiff_t>(block.first + i));
        }
      }
  });
  return filtered;
}

}  // namespace

template <class Normal>
Array<Normal> filter_normals(const FaceLists& within, const ListWeights& weight, const Array<Normal>& guide,
                             const Array<Normal>& normal, double range_sigma, Job& job) {
  const RangeWeight<float> similar(range_sigma);
  const bool guides_itself = &guide == &normal;
  return filter_each(
      within, weight, normal, job,
      [&](const FaceLists::Block& block, const std::vector<UnitNormal>& normals, std::vector<UnitNormal>& other) {
        if (!guides_itself) gather_normals(block, guide, other);
        const std::vector<UnitNormal>& guides = guides_itself ? normals : other;
        return [&](std::size_t i, const List& list) {
          NormalSum sum;
          const FourNormals here{guides[i][0], guides[i][1], guides[i][2]};
          visit_by_fours(list, [&](const std::uint16_t* four, FourFloats closeness) {
            const FourNormals there = four_normals(guides, four);
            sum.add(closeness * similar(squared_distances(there, here)),
                    guides_itself ? there : four_normals(normals, four));
          });
          return sum;
        };
      });
}

template <class Normal>
Array<Normal> mean_of_neighbourhoods(const FaceLists& within, const ListWeights& weight, const Array<Normal>& normal,
                                     Job& job) {
  return filter_each(within, weight, normal, job,
                     [&](const FaceLists::Block& /*block*/, const std::vector<UnitNormal>& normals,
                         std::vector<UnitNormal>& /*guides*/) {
                       return [&](std::size_t /*i*/, const List& list) {
                         NormalSum sum;
                         visit_by_fours(list, [&](const std::uint16_t* four, FourFloats closeness) {
                           sum.add(closeness, four_normals(normals, four));
                         });
                         return sum;
                       };
                     });
}

template Array<UnitNormal> filter_normals(const FaceLists&, const ListWeights&, const Array<UnitNormal>&,
                                          const Array<UnitNormal>&, double, Job&);
template Array<PackedNormal> filter_normals(const FaceLists&, const ListWeights&, const Array<PackedNormal>&,
                                            const Array<PackedNormal>&, double, Job&);
template Array<UnitNormal> mean_of_neighbourhoods(const FaceLists&, const ListWeights&, const Array<UnitNormal>&, Job&);
template Array<PackedNormal> mean_of_neighbourhoods(const FaceLists&, const ListWeights&, const Array<PackedNormal>&,
                                                    Job&);

}  // namespace vcg_core::detail
