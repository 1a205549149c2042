# SPDX-License-Identifier: GPL-3.0-or-later
"""Removes noise from triangle meshes and keeps their edges.

    V2 = anisosmooth.smooth(V, F)
"""

from ._core import Cancelled, version as __version__
from ._files import MeshFile, read, write
from ._measures import distance, estimate_noise, measure
from ._smooth import smooth

__all__ = ["Cancelled", "MeshFile", "distance", "estimate_noise", "measure", "read", "smooth", "write"]
