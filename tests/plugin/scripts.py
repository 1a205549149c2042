# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab filter scripts (.mlx) for our filters. A script lists all parameters: MeshLab 2020.09 aborts otherwise."""

SMOOTHING = "Anisotropic Feature-Preserving Smoothing"
GEODESIC = "Geodesic Distance by Virtual Source"
BILATERAL = "Bilateral Mesh Denoising"
NON_ITERATIVE = "Non-Iterative Feature-Preserving Smoothing"
GUIDED = "Guided Anisotropic Smoothing"
MEASURES = "Compute Geometric Measures"  # MeshLab's own; changes nothing

KINDS = {"sigma_c": "RichFloat", "sigma_s": "RichFloat", "sigma_n": "RichFloat", "rho": "RichFloat",
         "iterations": "RichInt", "boundary": "RichEnum", "selected": "RichBool", "start_vertex": "RichInt",
         "isolines": "RichInt", "strength": "RichFloat", "feature_angle": "RichFloat", "smooth_color": "RichBool"}
DEFAULTS = {SMOOTHING: {"sigma_c": 2, "sigma_s": 1, "sigma_n": 0.3, "rho": 2, "iterations": 1, "boundary": 0,
                        "selected": "false"},
            GEODESIC: {"start_vertex": 0, "isolines": 10},
            BILATERAL: {"sigma_c": 2, "sigma_s": 1, "iterations": 1, "boundary": 0, "selected": "false"},
            NON_ITERATIVE: {"sigma_c": 2, "sigma_s": 1, "boundary": 0, "selected": "false"},
            GUIDED: {"strength": 1, "feature_angle": 30, "iterations": 0, "boundary": 1, "selected": "false",
                     "smooth_color": "false"},
            MEASURES: {}}


def write(path, *names, **values):
    """Filters one after the other, with their defaults and `values` on top."""
    lines = ["<!DOCTYPE FilterScript>", "<FilterScript>"]
    for name in names:
        lines.append(f' <filter name="{name}">')
        for parameter, value in {**DEFAULTS[name], **values}.items():
            extra = ' enum_val0="fixed" enum_val1="free" enum_cardinality="2"' if parameter == "boundary" else ""
            lines.append(f'  <Param type="{KINDS[parameter]}" name="{parameter}" value="{value}"{extra}/>')
        lines.append(" </filter>")
    path.write_text("\n".join([*lines, "</FilterScript>", ""]))
    return path
