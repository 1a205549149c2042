// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vcg_core/filters/guided_parameters.h>

namespace vcg_core::detail {

/// All constants of the guided filter, and switches that leave a part of it out, for the ablation in docs/guided.md.
/// The constants were chosen on plateaus: a change by a quarter of any of them changes the benchmark's mean by at most
/// a few per cent.
struct GuidedSettings {
  /// Radius of a face's neighbourhood and standard deviation of its closeness weight, in local spacings.
  double radius = 1.9;
  double closeness = 1.0;
  /// No spacing is less than this many standard deviations of the noise, up to the spacing of the mesh's average edge:
  /// where edges are short, the same noise is more of an edge length, and it takes as wide a neighbourhood to remove
  /// it.
  double noise_spacing = 2.9;

  /// 0: `rounds_by_noise` times the noise in |e|, from fewest to most.
  int coarse_rounds = 0;
  double rounds_by_noise = 25;
  int fewest_rounds = 2;
  int most_rounds = 12;
  /// Range sigma of the coarse rounds: length of a difference of unit normals.
  double coarse_range = 0.4;
  /// Position updates after each coarse round.
  int coarse_updates = 2;

  int fine_rounds = 25;
  double fine_range = 0.3;

  /// Position updates with the final normals.
  int final_updates = 30;

  /// A patch is trusted as guide up to `patch_spread` times the median spread of the mesh's best patches (plus
  /// `patch_spread_floor`), and not at all from `patch_fade` times that on.
  double patch_spread = 3;
  double patch_spread_floor = 0.005;
  double patch_fade = 3;
  /// Range sigma of the mean that replaces patches that are not trusted: at least the first, at least the second times
  /// the median difference of adjoining normals.
  double ring_range_floor = 0.3;
  double ring_range = 1.8;

  /// A face is folded when its normal and its filtered normal have a smaller cosine than this.
  double fold_cosine = 0.2;
  int updates_between_fold_checks = 2;
  double unfold_step = 0.5;

  /// Standard deviation of the noise is the estimate times this.
  double noise_scale = 1;
  /// No vertex moves farther than this many standard deviations of the noise around it.
  double most_deviations = 5;
  /// Energy of the low-passed residual, in units of that of white noise, from which detail is brought back, and from
  /// which it is brought back in full.
  double detail_from = 1;
  double detail_full = 2;

  bool blend = true;             ///< off: fine rounds and detail recovery in place of the learned blend
  bool second_stage = true;      ///< off: the first blend is the last
  bool guide = true;             ///< off: the coarse rounds are plain bilateral
  bool guard_thin_parts = true;  ///< off: every face takes its best patch as guide
  bool fine = true;              ///< off: no fine rounds
  bool restart = true;           ///< off: the last updates start from the coarse positions, not from the noisy ones
  bool unfold = true;
  bool recover_detail = true;
  bool follow_edge_length = true;  ///< off: one spacing for the whole mesh
};

/// The settings that the parameters ask for.
/// @param coarse_rounds  0: by the noise
GuidedSettings guided_settings(const GuidedParameters& parameters, int coarse_rounds);

}  // namespace vcg_core::detail
