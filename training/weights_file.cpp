// SPDX-License-Identifier: GPL-3.0-or-later
#include "weights_file.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace training {

namespace {

using vcg_core::detail::table_unit;

void write_table(std::ostream& out, const char* name, const Table& table) {
  out << "constexpr std::size_t " << name << "_sizes[] = {";
  for (int k = 0; k < 4; ++k) out << (k > 0 ? ", " : "") << table.sizes[k];
  out << "};\n// clang-format off\nconstexpr std::int16_t " << name << "[] = {";
  int column = 120;
  for (const std::int16_t value : table.value) {
    const std::string text = std::to_string(value) + ',';
    if (column + static_cast<int>(text.size()) + 1 > 118) {
      out << "\n ";
      column = 1;
    }
    out << ' ' << text;
    column += static_cast<int>(text.size()) + 1;
  }
  out << "\n};\n// clang-format on\n";
  out << "static_assert(std::size(" << name << ") == values_in(" << name << "_sizes), \"" << name
      << " has the wrong number of weights\");\n";
  out << "static_assert(checksum(" << name << ", std::size(" << name
      << ")) == " << vcg_core::detail::checksum(table.value.data(), table.value.size()) << "U, \"" << name
      << " is damaged\");\n\n";
}

}  // namespace

Table table_of(const Network& network) {
  Table table{};
  const auto add = [&](float value) {
    const double scaled = std::round(value / table_unit);
    if (!(std::abs(scaled) <= 32767)) throw std::range_error("a weight is too large for the table");
    table.value.push_back(static_cast<std::int16_t>(scaled));
  };
  for (const float value : network.mean) add(value);
  for (const float value : network.deviation) add(value);
  table.sizes[0] = static_cast<std::size_t>(network.mean.size());
  for (std::size_t k = 0; k < network.matrix.size(); ++k) {
    table.sizes[k + 1] = static_cast<std::size_t>(network.matrix[k].rows());
    for (Eigen::Index row = 0; row < network.matrix[k].rows(); ++row)
      for (Eigen::Index column = 0; column < network.matrix[k].cols(); ++column) add(network.matrix[k](row, column));
    for (const float value : network.offset[k]) add(value);
  }
  return table;
}

void write_weights(const std::string& file, const std::string& noise, const std::string& made_by, const Table& first,
                   const Table& second) {
  std::ofstream out(file);
  out << "// SPDX-License-Identifier: GPL-3.0-or-later\n// The weights of the guided filter's blend for " << noise
      << " noise, in multiples of 2^-12. Made by\n//   " << made_by
      << "\n// Not to be edited: train again instead.\n\n"
         "#include \"blend_weights.h\"\n\n#include <iterator>\n\nnamespace vcg_core::detail {\n\nnamespace {\n\n";
  write_table(out, "first_stage", first);
  write_table(out, "second_stage", second);
  out << "}  // namespace\n\nconst BlendWeights& " << noise
      << "_noise_weights() {\n  static const BlendWeights weights{network_table(first_stage_sizes, first_stage), "
         "network_table(second_stage_sizes, second_stage)};\n  return weights;\n}\n\n}  // namespace "
         "vcg_core::detail\n";
  if (!out.flush()) throw std::runtime_error("cannot write '" + file + "'");
}

}  // namespace training
