// SPDX-License-Identifier: GPL-3.0-or-later
#include "ablation.h"

#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "network_trainer.h"

namespace training {

namespace {

using Eigen::Index;

/// As in vcg_core/src/filters/guided/blend/candidates.cpp.
const std::vector<std::string> names[2] = {
    {"noisy normals", "coarse rounds", "4 fine rounds", "16 fine rounds", "mean of the noisy ones", "three such means",
     "noisy ones, guided", "noisy ones, guided three times", "low-pass, 3.2 edges", "low-pass, 4.7 edges",
     "low-pass, 6.8 edges", "low-pass, 11 edges", "low-pass, 18 edges", "low-pass, 35 edges"},
    {"noisy normals", "the first stage", "3 fine rounds", "10 fine rounds", "6 narrower rounds", "mean", "three means",
     "noisy ones, guided", "noisy ones, guided three times", "moved positions", "low-pass, 4.4 edges",
     "low-pass, 8.9 edges"}};

struct Group {
  const char* name;
  std::size_t begin, end;
};

/// How many of the inputs are distances between candidates; the scalars follow.
std::size_t distances(const Samples& samples) { return vcg_core::detail::input_count(samples.candidate.size(), 0); }

Samples with_inputs(Samples samples, const std::vector<Index>& rows) {
  samples.input = Eigen::MatrixXf(samples.input(rows, Eigen::all));
  return samples;
}

}  // namespace

double mean_angle_to_truth(const Eigen::MatrixXf& normal, const Samples& samples) {
  double sum = 0;
  for (Index i = 0; i < normal.cols(); ++i)
    sum += samples.weight[i] * angle_between(normal.col(i), samples.truth.col(i));
  return sum / static_cast<double>(samples.weight.sum());
}

Samples without_candidate(Samples samples, std::size_t candidate) {
  const std::size_t count = samples.candidate.size();
  std::vector<Index> rows;
  Index row = 0;
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b, ++row)
      if (a != candidate && b != candidate) rows.push_back(row);
  for (; row < samples.input.rows(); ++row) rows.push_back(row);
  samples.candidate.erase(samples.candidate.begin() + static_cast<std::ptrdiff_t>(candidate));
  return with_inputs(std::move(samples), rows);
}

Samples without_scalars(Samples samples, std::size_t begin, std::size_t end) {
  const auto first = static_cast<Index>(distances(samples));
  std::vector<Index> rows;
  for (Index row = 0; row < samples.input.rows(); ++row)
    if (row < first + static_cast<Index>(begin) || row >= first + static_cast<Index>(end)) rows.push_back(row);
  return with_inputs(std::move(samples), rows);
}

void ablate(int stage, const Samples& learned, const Samples& kept_out, int epochs, std::uint64_t seed,
            std::ostream& out) {
  std::ostringstream log;
  const auto error = [&](const Samples& from, const Samples& of, std::uint64_t with_seed) {
    return mean_angle_to_truth(blend(train(from, {40, 24}, epochs, with_seed, log), of), of);
  };
  const auto row = [&](const std::string& what, double angle, double all) {
    std::ostringstream line;
    line << "| " << what << " | " << std::fixed << std::setprecision(3) << angle << " | " << std::showpos
         << std::setprecision(1) << 100 * (angle / all - 1) << " % |\n";
    out << line.str() << std::flush;
  };
  out << "| stage " << stage << " | mean error, degrees | against all |\n|---|---|---|\n";
  const double all = error(learned, kept_out, seed);
  row("all", all, all);
  for (const std::uint64_t other : {seed + 1, seed + 2}) row("all, another seed", error(learned, kept_out, other), all);
  const std::size_t scalars = static_cast<std::size_t>(learned.input.rows()) - distances(learned);
  for (const Group& group : {Group{"spread of normals", 0, 3}, Group{"noise", 3, 4}, Group{"spacing", 4, 5},
                             Group{"differences around the face", 5, scalars}})
    row(std::string("without ") + group.name,
        error(without_scalars(learned, group.begin, group.end), without_scalars(kept_out, group.begin, group.end),
              seed),
        all);
  for (std::size_t c = 0; c < learned.candidate.size(); ++c)
    row("without candidate: " + names[stage - 1].at(c),
        error(without_candidate(learned, c), without_candidate(kept_out, c), seed), all);
}

}  // namespace training
