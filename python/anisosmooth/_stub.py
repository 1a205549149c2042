# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints __init__.pyi: `python -m anisosmooth._stub`. Keywords of smooth() come from the core's table of parameters."""

from ._smooth import CATALOGUE, COMMON, method_keywords

HEAD = '''# SPDX-License-Identifier: GPL-3.0-or-later
# Made by `python -m anisosmooth._stub`; tests/python/test_stub.py holds it current.
import os
from collections.abc import Callable
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

__version__: str
Progress = Callable[[float, str], bool | None]

class Cancelled(Exception): ...

class MeshFile:
    @property
    def V(self) -> npt.NDArray[Any]: ...
    @property
    def F(self) -> npt.NDArray[np.int64]: ...
    @property
    def creases(self) -> npt.NDArray[np.int64] | None: ...
    @property
    def colors(self) -> npt.NDArray[np.uint8] | None: ...
    @property
    def scalars(self) -> npt.NDArray[np.float64] | None: ...
    @property
    def selected(self) -> npt.NDArray[np.bool_] | None: ...
    @property
    def warnings(self) -> list[str]: ...

def read(path: str | os.PathLike[str]) -> MeshFile: ...
def write(
    path: str | os.PathLike[str],
    V: npt.ArrayLike,
    F: npt.ArrayLike | None = None,
    *,
    colors: npt.ArrayLike | None = None,
    scalars: npt.ArrayLike | None = None,
    like: MeshFile | None = None,
) -> None: ...
def distance(
    V: npt.ArrayLike, F: npt.ArrayLike, source: int, progress: Progress | None = None
) -> npt.NDArray[np.float64]: ...
def estimate_noise(
    V: npt.ArrayLike, F: npt.ArrayLike, threads: int = 0, progress: Progress | None = None
) -> float: ...
def measure(
    V: npt.ArrayLike,
    F: npt.ArrayLike,
    V_ref: npt.ArrayLike,
    F_ref: npt.ArrayLike | None = None,
    V_noisy: npt.ArrayLike | None = None,
    threads: int = 0,
) -> dict[str, Any]: ...
'''

TYPES_OF_COMMON = {
    "selected": "npt.ArrayLike | None",
    "weights": "npt.ArrayLike | None",
    "creases": "npt.ArrayLike | None",
    "max_displacement": "float | None",
    "weld_distance": "float",
    "colors": "npt.ArrayLike | None",
    "scalars": "npt.ArrayLike | None",
    "threads": "int",
    "check": "bool",
    "progress": "Progress | None",
    "return_report": "bool",
}


def _type(rows):
    row = next(iter(rows.values()))
    if row["kind"] == "str":
        return "Literal[" + ", ".join(f'"{choice}"' for choice in row["choices"]) + "] | None"
    return f"{row['kind']} | None"


def stub():
    methods = ", ".join(f'"{method}"' for method in CATALOGUE)
    lines = ["def smooth(", "    V: npt.ArrayLike,", "    F: npt.ArrayLike,"]
    lines += [f'    method: Literal[{methods}] = "guided",', "    *,"]
    lines += [f"    {name}: {_type(rows)} = None," for name, rows in method_keywords().items()]
    lines += [f"    {name}: {TYPES_OF_COMMON[name]} = {default!r}," for name, default in COMMON.items()]
    return HEAD + "\n".join([*lines, ") -> Any: ...", ""])


if __name__ == "__main__":
    print(stub(), end="")
