// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <vcg/space/color4.h>

namespace mesh_tools::io {

/// Files do not say whether their colours are fractions or whole numbers up to 255. All components of a file are of one
/// kind, and the largest of them tells.
/// @return by what components are to be multiplied to be 0 to 255
inline double color_scale(double largest) {
  constexpr double one = 1.001;  // rounding may be on the way
  return largest <= one ? 255 : 1;
}

/// A number from 0 to 255, to the nearest; 0 if it is not a number.
inline unsigned char color_byte(double value) {
  return value > 0 ? static_cast<unsigned char>(std::lround(std::min(value, 255.0))) : 0;
}

/// Colours as a file has them, until it is known what its components mean.
class RawColors {
 public:
  void add(std::size_t item, int component, double value) {
    if (colors_.empty() || colors_.back().item != item) colors_.push_back({item, {none, none, none, none}});
    colors_.back().part[static_cast<std::size_t>(component)] = value;
    largest_ = std::max(largest_, value);
  }

  bool empty() const { return colors_.empty(); }
  double largest() const { return largest_; }

  /// Gives vertices or faces their colours; components that they have not stay, and are white where there was none.
  /// With no colours at all, nothing is done.
  /// @param count  of the vertices or faces
  void apply(std::size_t count, double scale, std::vector<vcg::Color4b>& to) const {
    if (colors_.empty()) return;
    to.resize(count, vcg::Color4b(255, 255, 255, 255));
    for (const Color& color : colors_)
      for (int k = 0; k < 4; ++k)
        if (const double value = color.part[static_cast<std::size_t>(k)]; value != none)
          to[color.item][k] = color_byte(scale * value);
  }

 private:
  static constexpr double none = -std::numeric_limits<double>::max();

  struct Color {
    std::size_t item;
    std::array<double, 4> part;
  };
  std::vector<Color> colors_;
  double largest_ = 0;
};

}  // namespace mesh_tools::io
