"""Triangle meshes of surfaces."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from .arrays import Floats


class Mesh(NamedTuple):
    """A triangle mesh with what is known of the surface at its vertices. ``vertices, faces, *_ = surface.mesh(48)`` takes the
    usual two."""

    vertices: Floats
    """Points, shape (k, 3), in the unit of the boundary."""
    faces: npt.NDArray[np.uint32]
    """Triangles by the indices of their vertices, shape (t, 3), counter-clockwise seen against the normals."""
    normals: Floats
    """Unit normals, shape (k, 3); where the surface is singular, those of the triangles around."""
    parameters: Floats
    """(u, v) of every vertex, shape (k, 2); at a vertex of several patches, of the first."""
    mean_curvature: Floats
    """Mean curvature, shape (k,), 1/length; not a number where there is none."""
    gauss_curvature: Floats
    """Gauss curvature, shape (k,), 1/length²; not a number where there is none."""
    patches: npt.NDArray[np.uint32] | None
    """For surfaces of several patches: the patch of every triangle, shape (t,)."""
