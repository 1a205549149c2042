// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "network_trainer.h"

namespace training {

/// A network's weights as integers, in the order of vcg_core::detail::NetworkTable.
struct Table {
  std::size_t sizes[4];
  std::vector<std::int16_t> value;
};

/// @throws std::range_error if a weight is too large for the table
Table table_of(const Network& network);

/// Writes the source file of the weights. @throws std::runtime_error if it cannot be written
/// @param noise    white or correlated
/// @param made_by  a line of comment
void write_weights(const std::string& file, const std::string& noise, const std::string& made_by, const Table& first,
                   const Table& second);

}  // namespace training
