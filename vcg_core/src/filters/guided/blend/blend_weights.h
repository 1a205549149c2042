// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "blend_network.h"

namespace vcg_core::detail {

const NetworkTable& first_blend_weights();
const NetworkTable& second_blend_weights();

}  // namespace vcg_core::detail
