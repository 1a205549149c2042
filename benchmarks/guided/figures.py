# SPDX-License-Identifier: GPL-3.0-or-later
"""Means over cases, and what is compared. Figures are dictionaries: of a method, by case."""

from statistics import mean

from .cases import CAD, SCANS, THIN, Case, is_base


def average(figures, name, cases=None):
    """Of the cases for which cases(case) holds; of the base ones without it. None without any."""
    values = [abs(f[name]) for c, f in figures.items() if f[name] is not None and (cases or is_base)(c)]
    return mean(values) if values else None


def sharp(figures):
    """Error at sharp edges, over the base cases that have some."""
    values = [f["sharp_normal_error_mean"] for c, f in figures.items() if f["sharp_faces"] > 0 and is_base(c)]
    return mean(values)


def volume(figures):
    """Over closed shapes that enclose more than a skin."""
    return average(figures, "volume_change_percent",
                   lambda c: is_base(c) and c.shape not in (*THIN, *SCANS))


def worst_against(results, peers, cases=is_base):
    """The largest ratio of the guided method's error to the best peer's, and its case."""
    ratios = {c: f["normal_error_mean"] / min(results[p][c]["normal_error_mean"] for p in peers)
              for c, f in results["guided"].items() if cases(c)}
    case = max(ratios, key=ratios.get)
    return ratios[case], case


def drift_of(figures, level):
    return average(figures, "true_tangential_drift",
                   lambda c: is_base(c) and c.shape in CAD and c.level == level and c.direction == "normal")


def grading(figures, level):
    return figures[Case("graded_cube", level, "normal")]["normal_error_mean"] / \
        figures[Case("cube", level, "normal")]["normal_error_mean"]
