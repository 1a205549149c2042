# SPDX-License-Identifier: GPL-3.0-or-later
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
def smooth(
    V: npt.ArrayLike,
    F: npt.ArrayLike,
    method: Literal["paper", "bmd", "jones", "laplacian", "hc", "hc_vcglib", "taubin", "guided"] = "guided",
    *,
    sigma_c: float | None = None,
    sigma_s: float | None = None,
    sigma_n: float | None = None,
    rho: float | None = None,
    iterations: int | None = None,
    boundary: Literal["fixed", "free"] | None = None,
    gaussian: Literal["standard_deviation", "printed"] | None = None,
    strength: float | None = None,
    feature_angle: float | None = None,
    smooth_color: bool | None = None,
    blend: Literal["on", "off"] | None = None,
    selected: npt.ArrayLike | None = None,
    weights: npt.ArrayLike | None = None,
    creases: npt.ArrayLike | None = None,
    max_displacement: float | None = None,
    weld_distance: float = 0.0,
    colors: npt.ArrayLike | None = None,
    scalars: npt.ArrayLike | None = None,
    threads: int = 0,
    check: bool = False,
    progress: Progress | None = None,
    return_report: bool = False,
) -> Any: ...
