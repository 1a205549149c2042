// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tiles {

Box::Box() {
  min.fill(std::numeric_limits<double>::infinity());
  max.fill(-std::numeric_limits<double>::infinity());
}

void Box::extend(const Point& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    min[k] = std::min(min[k], p[k]);
    max[k] = std::max(max[k], p[k]);
  }
}

Grid::Grid(const Box& box, std::uint32_t along) : origin_(box.min) {
  constexpr std::uint32_t most_along = 256;
  along = std::clamp<std::uint32_t>(along, 1, most_along);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, box.max[k] - box.min[k]);
  if (!(longest > 0)) return;  // all points are at one place
  side_ = longest / along;
  for (std::size_t k = 0; k < 3; ++k)
    size_[k] =
        std::clamp<std::uint32_t>(static_cast<std::uint32_t>(std::ceil((box.max[k] - box.min[k]) / side_)), 1, along);
}

}  // namespace tiles
