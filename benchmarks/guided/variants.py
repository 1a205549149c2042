# SPDX-License-Identifier: GPL-3.0-or-later
"""What each part of the guided method brings, and what less drift costs: by benchmarks/guided_variant.cpp."""

from .cases import GROUPS
from .figures import average, drift_of, grading, sharp, worst_against
from .methods import rivals_of
from .runs import say
from .tables import COLUMNS, head, number, row, summary_row

# Of the filter without its blend.
CLASSICAL = {
    "all parts": [],
    "no guides: coarse rounds are bilateral": ["guide=0"],
    "every best patch trusted (no guard for thin parts)": ["guard_thin_parts=0"],
    "last updates from the coarse positions": ["restart=0"],
    "no unfolding": ["unfold=0"],
    "no detail brought back": ["recover_detail=0"],
    "one spacing for the whole mesh": ["follow_edge_length=0"],
    "spacing does not follow the noise": ["noise_spacing=0"],
    "no fine rounds": ["fine=0"],
}
ABLATION = {
    "with the blend": [],
    "one stage of the blend": ["second_stage=0"],
    **{f"without the blend: {name}": ["blend=0", *settings] for name, settings in CLASSICAL.items()},
}

# What could bring less drift within the surface: fewer position updates, less unfolding, other normals.
TRADE_OFF = {
    "as shipped: 30 last updates": [],
    **{f"{count} last updates": [f"final_updates={count}"] for count in (5, 10, 20, 60)},
    "half the unfolding step": ["unfold_step=0.25"],
    "10 last updates, no unfolding": ["final_updates=10", "unfold=0"],
    "one update in a coarse round": ["coarse_updates=1"],
    "twice the coarse rounds": ["rounds_by_noise=40", "most_rounds=24"],
}


def variant_table(bench, variants, cases, results, methods):
    peers = rivals_of(methods)
    text = head([*COLUMNS, "drift at 0.2 / 0.3", "graded", "worst"])
    for name, settings in variants.items():
        say(f"variant: {name}")
        figures = {c: bench.variant(settings, c) for c in cases}
        ratio, _ = worst_against({**results, "guided": figures}, peers)
        graded = " / ".join(f"{grading(figures, level):.2f}" for level in (0.1, 0.2, 0.3))
        text += summary_row(name, figures).rstrip("\n") + \
            f" {drift_of(figures, 0.2):.4f} / {drift_of(figures, 0.3):.4f} | {graded} | {ratio:.2f} |\n"
    return text


def flipped(figures):
    """Flipped faces, over all cases."""
    return str(sum(f["flipped_faces"] for f in figures.values()))


def trade_off_table(bench, cases, results):
    def drift_row(name, figures):
        return row([name, number(average(figures, "normal_error_mean"), 3), number(sharp(figures), 2),
                    number(average(figures, "normal_error_mean", GROUPS["thin"]), 2),
                    number(average(figures, "distance_rms"), 4), number(average(figures, "true_tangential_drift"), 4),
                    *(number(drift_of(figures, level), 4) for level in (0.2, 0.3)), flipped(figures)])

    text = head(["", "normal error", "sharp", "thin", "RMS", "drift", "drift, CAD 0.2", "drift, CAD 0.3",
                 "flipped faces"])
    text += drift_row("noisy", results["noisy"])
    for name, settings in TRADE_OFF.items():
        say(f"trade-off: {name}")
        text += drift_row(name, {c: bench.variant(settings, c) for c in cases})
    return text
