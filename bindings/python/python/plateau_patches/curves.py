"""Curves: of files, of arrays."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import Path

import numpy as np
import numpy.typing as npt

from . import _engine
from .arrays import Floats, number, numbers, points, whole
from .errors import BoundaryError

# What every 3DM file begins with.
_RHINO = b"3D Geometry File Format"


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve of a boundary. :meth:`polyline`, :meth:`bezier`, :meth:`spline` and :meth:`circle` make one."""

    kind: str
    """``polyline`` (points, or samples of a smooth curve between corners), ``spline`` or ``arc``."""
    points: Floats
    """The points, shape (n, 3): of a polyline, of control; of an arc its centre and the unit vectors of its axes."""
    degree: int = 1
    """Of a spline."""
    knots: list[float] = field(default_factory=list)
    """Of a spline: as many as points, and ``degree`` + 1 more."""
    weights: list[float] | None = None
    """Of a rational spline, one a point."""
    radii: tuple[float, float] | None = None
    """Of an arc, along its axes."""
    angles: tuple[float, float] | None = None
    """Of an arc: where it begins and ends, in radians from the first axis."""
    closed: bool = False
    """Whether the last point of a polyline is joined to the first."""
    name: str = ""
    """What its file calls it."""

    def __post_init__(self) -> None:
        if self.kind not in ("polyline", "spline", "arc"):
            raise BoundaryError(f"{self.kind!r} is no kind of curve; give polyline, spline or arc")
        object.__setattr__(self, "points", points(self.points, self.name or f"the {self.kind}"))

    @staticmethod
    def polyline(points_: npt.ArrayLike, *, closed: bool = False, name: str = "") -> Curve:
        """Points (n, 3), joined by straight lines where the direction turns like a corner, else samples of a smooth curve."""
        given = points(points_, name or "the polyline")
        if closed and len(given) > 2 and (given[0] == given[-1]).all():
            given = given[:-1].copy()
        return Curve("polyline", given, closed=closed, name=name)

    @staticmethod
    def bezier(points_: npt.ArrayLike, *, name: str = "") -> Curve:
        """The Bézier curve of control points (n + 1, 3)."""
        given = points(points_, name or "the Bézier curve")
        degree = len(given) - 1
        return Curve("spline", given, degree, [0.0] * len(given) + [1.0] * len(given), name=name)

    @staticmethod
    def spline(
        points_: npt.ArrayLike,
        knots: Sequence[float] | Floats,
        degree: int,
        *,
        weights: Sequence[float] | Floats | None = None,
        name: str = "",
    ) -> Curve:
        """The B-spline of control points (n, 3) and n + ``degree`` + 1 knots, rational if there are ``weights`` (n,)."""
        given = points(points_, name or "the spline")
        order = whole(degree, "the degree of a spline", 1, 1000)
        return Curve("spline", given, order, _row(knots, "knots"), None if weights is None else _row(weights, "weights"), name=name)

    @staticmethod
    def circle(center: npt.ArrayLike, normal: npt.ArrayLike, radius: float, *, name: str = "") -> Curve:
        """The circle around ``center`` in the plane with a normal of any length."""
        middle, up = (_place(place, f"the {what} of the circle") for place, what in ((center, "centre"), (normal, "normal")))
        length, radius = float(np.linalg.norm(up)), number(radius, "the radius of the circle")
        if not (length > 0.0 and radius > 0.0):
            raise BoundaryError("a circle has a normal that is not zero and a radius above zero")
        up = up / length
        first = np.cross(np.eye(3)[int(np.argmin(np.abs(up)))], up)
        first /= np.linalg.norm(first)
        rows = np.stack([middle, first, np.cross(up, first)])
        return Curve("arc", rows, 2, radii=(radius, radius), angles=(0.0, 2.0 * np.pi), name=name)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Curve):
            return NotImplemented
        mine, theirs = ({**vars(curve), "points": curve.points.tolist()} for curve in (self, other))
        return mine == theirs

    def __hash__(self) -> int:
        return hash((self.kind, self.name, self.points.tobytes()))


def _row(values: npt.ArrayLike, what: str) -> list[float]:
    array = numbers(values, what)
    if array.ndim != 1:
        raise BoundaryError(f"{what} of shape {array.shape}; a list of numbers is expected")
    return [float(value) for value in array]


def _place(value: npt.ArrayLike, what: str) -> Floats:
    array = numbers(value, what)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise BoundaryError(f"{what} is {np.asarray(value).tolist()}; three finite numbers are expected")
    return array


@dataclass(frozen=True)
class Curves:
    """The curves of a file, in its order; :func:`fill` makes one boundary of them, whatever their order and direction."""

    curves: list[Curve]
    """At least one."""
    notes: list[str]
    """What is to be said of the file: what was passed over, what was assumed."""
    unit: str | None = None
    """What its numbers are, where the file says so: ``mm``, ``cm``, ``m``, ``inch``, ``ft``, …"""

    def __iter__(self) -> Iterator[Curve]:
        return iter(self.curves)

    def __len__(self) -> int:
        return len(self.curves)

    def __getitem__(self, place: int) -> Curve:
        return self.curves[place]


def from_file(path: str | PathLike[str]) -> Curves:
    """The curves of a file: a table of points (CSV and its relatives), lines and free-form curves of OBJ, edges of STEP,
    entities of DXF; curves of 3DM, or the free edges of its surfaces, with the extra ``rhino``. What it is follows from its content. No unit is converted.

    Raises:
        BoundaryError: a file of another kind, or one that is broken; with the line where one is at fault.
        OSError: the file system.
    """
    path = Path(fspath(path))
    content = path.read_bytes()
    if content.startswith(_RHINO):
        from .rhino import load

        return load(path)
    fields, notes, unit = _engine.read_curves(content, path.name)
    curves = [
        Curve(kind, given, degree, knots, weights, radii, angles, closed, name)
        for name, kind, given, degree, knots, weights, radii, angles, closed in fields
    ]
    return Curves(curves, notes, unit)
