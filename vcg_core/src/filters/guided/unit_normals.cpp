// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit_normals.h"

#include "job.h"

namespace vcg_core::detail {

namespace {

constexpr std::size_t grain = 4096;

template <class To, class From, class Convert>
Array<To> converted(const Array<From>& from, Job& job, const Convert& convert) {
  Array<To> to(from.size());
  job.parallel(from.size(), grain, Loop::minor, [&](Chunks& chunks) {
    while (chunks.next())
      for (std::size_t i = chunks.begin(); i < chunks.end(); ++i) to[i] = convert(from[i]);
  });
  return to;
}

}  // namespace

Array<UnitNormal> in_single(const Array<Vec3>& normal, Job& job) {
  return converted<UnitNormal>(normal, job, [](const Vec3& n) { return in_single(n); });
}

Array<Vec3> in_double(const Array<UnitNormal>& normal, Job& job) {
  return converted<Vec3>(normal, job, [](const UnitNormal& n) { return Vec3(n[0], n[1], n[2]); });
}

}  // namespace vcg_core::detail
