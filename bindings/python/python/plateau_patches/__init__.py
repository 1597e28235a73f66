"""Boundary curves in, the best Bézier-like surface spanning them out, with honest figures.

>>> import plateau_patches as pp
>>> u0, u1 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]], [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
>>> v0, v1 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]], [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]
>>> patch = pp.least_area(u0, u1, v0, v1, degree=6)
>>> patch.evaluate(0.5, 0.5).shape
(3,)
"""

from __future__ import annotations

from importlib.metadata import version as _version

from .curves import Curve, Curves, from_file
from .errors import BoundaryError, ExperimentError, Fault, FormatError, MethodError, PlateauError
from .experiment import Results, load, run
from .filling import fill
from .mesh import Mesh
from .methods import (
    deformation,
    dirichlet,
    discrete_coons,
    extremal,
    gt,
    harmonic,
    helicoid,
    least_area,
    mask,
    trapezium_helicoid,
    triangle,
)
from .report import Report
from .surface import Face, Kink, LowerBound, Surface

__version__ = _version("plateau_patches")



def __dir__() -> list[str]:
    return [*__all__, "__version__"]


__all__ = [
    "BoundaryError",
    "Curve",
    "Curves",
    "ExperimentError",
    "Face",
    "Fault",
    "FormatError",
    "Kink",
    "LowerBound",
    "Mesh",
    "MethodError",
    "PlateauError",
    "Report",
    "Results",
    "Surface",
    "deformation",
    "dirichlet",
    "discrete_coons",
    "extremal",
    "fill",
    "from_file",
    "gt",
    "harmonic",
    "helicoid",
    "least_area",
    "load",
    "mask",
    "run",
    "trapezium_helicoid",
    "triangle",
]
