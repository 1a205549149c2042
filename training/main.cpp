// SPDX-License-Identifier: GPL-3.0-or-later
// train_blend NOISE OUT.cpp: trains the networks of the guided filter's blend on generated meshes, says how well they
// do on meshes that they have not seen, and writes their weights.

#include <cstdint>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "ablation.h"
#include "network_trainer.h"
#include "samples.h"
#include "weights_file.h"

namespace {

using namespace training;

/// Mean angle in degrees, by family, of what is blended and of each candidate.
void report(const Samples& samples, const Eigen::MatrixXf& blended, std::ostream& out) {
  std::map<std::string, std::vector<double>> sum;
  std::map<std::string, double> count;
  const auto angle = [&](const Eigen::MatrixXf& normal, Eigen::Index i) {
    return angle_between(normal.col(i), samples.truth.col(i));
  };
  for (Eigen::Index i = 0; i < blended.cols(); ++i)
    for (const std::string& family : {std::string(samples.family[static_cast<std::size_t>(i)]), std::string("all")}) {
      auto& row = sum[family];
      row.resize(samples.candidate.size() + 1);
      row[0] += angle(blended, i);
      for (std::size_t c = 0; c < samples.candidate.size(); ++c) row[c + 1] += angle(samples.candidate[c], i);
      ++count[family];
    }
  for (const auto& [family, row] : sum) {
    out << family << ": blend " << row[0] / count[family] << ", candidates";
    for (std::size_t c = 1; c < row.size(); ++c) out << ' ' << row[c] / count[family];
    out << '\n';
  }
  out << std::flush;
}

}  // namespace

int main(int argc, char** argv) {
  std::string noise, out, made_by;
  std::uint64_t seed = 1;
  std::size_t meshes = 300;
  int epochs = 8;
  CLI::App app("Trains the networks of the guided filter's blend.");
  bool ablation = false;
  app.add_option("NOISE", noise, "white or correlated")->required()->check(CLI::IsMember({"white", "correlated"}));
  app.add_option("OUT", out, "source file to be written");
  app.add_flag("--ablate", ablation, "say what seeds, candidates and scalars make, and write nothing");
  app.add_option("--seed", seed, "of the meshes and of the training")->capture_default_str();
  app.add_option("--meshes", meshes, "to learn from; a quarter as many are kept to look at the result")
      ->capture_default_str();
  app.add_option("--epochs", epochs, "times that each face is seen")->capture_default_str();
  app.add_option("--made-by", made_by, "comment in the file");
  app.final_callback([&] {
    if (out.empty() != ablation) throw CLI::ValidationError("OUT or --ablate is needed, not both");
  });
  CLI11_PARSE(app, argc, argv);
  try {
    const NoiseKind kind = noise == "white" ? NoiseKind::white : NoiseKind::correlated;
    constexpr std::size_t faces = 4000;
    const std::size_t all = meshes + meshes / 4;
    std::vector<Table> tables;
    for (int stage = 1; stage <= 2; ++stage) {
      std::unique_ptr<vcg_core::detail::BlendNetwork> before;
      if (stage == 2) {
        const Table& t = tables[0];
        before = std::make_unique<vcg_core::detail::BlendNetwork>(vcg_core::detail::NetworkTable{
            {t.sizes[0], t.sizes[1], t.sizes[2], t.sizes[3]}, t.value.data(), t.value.size()});
      }
      const Samples samples = draw_samples(kind, seed, 0, meshes, before.get(), faces);
      std::cout << "stage " << stage << ": " << samples.input.cols() << " faces, " << samples.input.rows()
                << " inputs, " << samples.candidate.size() << " candidates\n";
      const Network network = train(samples, {40, 24}, epochs, seed + static_cast<std::uint64_t>(stage), std::cout);
      const Samples kept_out = draw_samples(kind, seed, meshes, all, before.get(), faces);
      report(kept_out, blend(network, kept_out), std::cout);
      if (ablation) ablate(stage, samples, kept_out, epochs, seed, std::cout);
      tables.push_back(table_of(network));
    }
    if (!ablation) write_weights(out, noise, made_by, tables[0], tables[1]);
  } catch (const std::exception& error) {
    std::cerr << "train_blend: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
