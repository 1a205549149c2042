// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictures.h"

namespace anisosmooth {

Pictures draw_pictures(const Comparison& /*comparison*/, const View& /*view*/,
                       const std::filesystem::path& /*folder*/) {
  return {{}, "no pictures: the programs that draw them are only called on Linux"};
}

}  // namespace anisosmooth
