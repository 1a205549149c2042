# SPDX-License-Identifier: GPL-3.0-or-later
import inspect
import json
import warnings

import numpy as np

from . import _arrays, _core

CATALOGUE = _core.catalogue()

# What every method takes besides the parameters of its own, with the defaults.
COMMON = {
    "selected": None,
    "weights": None,
    "creases": None,
    "max_displacement": None,
    "weld_distance": 0.0,
    "colors": None,
    "scalars": None,
    "threads": 0,
    "check": False,
    "progress": None,
    "return_report": False,
}


def parameters_of(method):
    """The rows of the core's table of parameters that are keywords here; `selected` takes an array instead."""
    return [row for row in CATALOGUE[method]["parameters"] if not row["by_selection"]]


def method_keywords():
    """Every method's parameters, each name once, with its rows by method."""
    rows = {}
    for method in CATALOGUE:
        for row in parameters_of(method):
            rows.setdefault(row["name"], {})[method] = row
    return rows


def smooth(V, F, method="guided", **keywords):
    given = {**COMMON, **keywords}
    parameters = {name: given.pop(name) for name in list(given) if name not in COMMON}
    unknown = [name for name in parameters if name not in method_keywords()]
    if unknown:
        raise TypeError(f"smooth() got an unexpected keyword argument '{unknown[0]}'")
    parameters = {name: value for name, value in parameters.items() if value is not None}

    vertices = _arrays.positions(V)
    faces = _arrays.triangles(F)
    result = vertices.copy(order="C")
    count = len(result)
    weights = None if given["weights"] is None else _arrays.per_vertex(given["weights"], "weights", count)
    selected = None if given["selected"] is None else _arrays.marks(given["selected"], "selected", count)
    creases = None if given["creases"] is None else _arrays.edges(given["creases"])
    attributes = []
    colors = scalars = None
    if given["colors"] is not None:
        colors, back = _arrays.colors(given["colors"], count)
        attributes.append(lambda: back(colors))
    if given["scalars"] is not None:
        scalars = _arrays.per_vertex(given["scalars"], "scalars", count).copy()
        attributes.append(lambda: scalars)
    if attributes:
        parameters.setdefault("smooth_color", True)
    limit = given["max_displacement"]
    report = json.loads(
        _core.smooth(
            result, faces, method, parameters, _arrays.without_place(result, faces, creases), selected, weights, creases,
            colors, scalars, given["weld_distance"], np.inf if limit is None else limit, given["threads"],
            given["check"], given["progress"],
        )
    )  # fmt: skip
    results = [result, *(attribute() for attribute in attributes)]
    if given["return_report"]:
        results.append(report)
    else:
        for sentence in report["warnings"]:
            warnings.warn(sentence, stacklevel=2)
    return results[0] if len(results) == 1 else tuple(results)


def _default_text(rows):
    values = {json.dumps(row["default"]) for row in rows.values()}
    if len(values) == 1:
        return repr(next(iter(rows.values()))["default"])
    return ", ".join(f"{row['default']!r} ({method})" for method, row in rows.items())


def documentation():
    """The docstring of smooth(), with the core's own table of parameters."""
    lines = [_HEAD, "Parameters of the methods (an omitted one has the method's default)", "-" * 67]
    for name, rows in method_keywords().items():
        first = next(iter(rows.values()))
        lines += [f"{name} : {first['kind']}, default {_default_text(rows)}", f"    Methods: {', '.join(rows)}.", ""]
        texts = {}
        for method, row in rows.items():
            texts.setdefault(row["help"], []).append(method)
        for text, methods in texts.items():
            about = "" if len(texts) == 1 else f"{', '.join(methods)}: "
            lines.insert(len(lines) - 1, f"    {about}{text}")
    return "\n".join(lines) + _TAIL


def signature():
    """The signature of smooth(): parameters of the methods are None by default, as their defaults depend on it."""
    keyword = inspect.Parameter.KEYWORD_ONLY
    parameters = [
        inspect.Parameter("V", inspect.Parameter.POSITIONAL_OR_KEYWORD),
        inspect.Parameter("F", inspect.Parameter.POSITIONAL_OR_KEYWORD),
        inspect.Parameter("method", inspect.Parameter.POSITIONAL_OR_KEYWORD, default="guided"),
    ]
    parameters += [inspect.Parameter(name, keyword, default=None) for name in method_keywords()]
    parameters += [inspect.Parameter(name, keyword, default=default) for name, default in COMMON.items()]
    return inspect.Signature(parameters)


_HEAD = """Takes the noise off a triangle mesh and keeps its edges.

Lengths marked "in average edge lengths" are multiples of the mean length of the mesh's edges. Vertices at exactly the
same place are one vertex of the surface: seams do not open. The result does not depend on the number of threads, and
is bit for bit that of the command line.

V : (n, 3) float32 or float64
    Positions. Other numbers are taken as float64. Never changed. Vertices without a finite place are passed over if no
    face or crease uses them, and refused otherwise.
F : (m, 3) integers
    Triangles, as indices of rows of V.
method : str
    "guided" has nothing to set; "paper" is the filter of the paper; the others are for comparison: {methods}.
selected : (n,) bool, or indices of vertices
    Only these move; all others are neighbours.
weights : (n,) numbers from 0 to 1
    How far each vertex follows the filter. With 0 it stays, bit for bit.
creases : (k, 2) integers
    Edges, as pairs of vertices, that the guided filter keeps sharp however flat they are.
max_displacement : float
    No vertex moves farther, in the unit of V.
weld_distance : float
    Vertices at most this far apart, in the unit of V, are one vertex of the surface. 0: those at exactly the same place.
colors : (n, 3) or (n, 4), bytes or fractions;  scalars : (n,) numbers
    Smoothed as well, but not across edges (method guided), and returned after V.
threads : int
    0: one for each processor. The result does not depend on it.
check : bool
    Also counts the faces of the result that cut through others.
progress : callable (fraction, stage) -> bool
    Called at most ten times a second. Returning False ends the work: Cancelled is raised.
return_report : bool
    Also returns a dictionary of what was done, as the command line's --report writes it. Without it, its warnings are
    issued as Python's.
""".replace("{methods}", ", ".join(name for name in CATALOGUE if name not in ("guided", "paper")))

_TAIL = """
Returns
-------
V2 : array of V's type and shape, then colors and scalars if they were given, then the report if asked for

Raises
------
ValueError : an array, the mesh or a parameter cannot be used; the sentence says why
Cancelled : progress returned False
KeyboardInterrupt, MemoryError : within 0.2 s of Ctrl+C; too little memory
"""

smooth.__signature__ = signature()
smooth.__doc__ = documentation()
