"""From curves to the surface that spans them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _engine
from .arrays import number, points, whole
from .curves import Curve, Curves, from_file
from .errors import BoundaryError
from .surface import Surface

# The highest degree of patches that share edges, as in experiments.
_HIGHEST = 24

Told = Callable[[str, int, "int | None"], object]


@dataclass(frozen=True)
class Options:
    """How a boundary is filled, see :func:`fill`."""

    name: str
    degree: int | None
    energy: str
    tolerance: float
    rim_tolerance: float | None
    weld: float | None
    corner_angle: float | None
    bound: bool
    layers: int
    accuracy: float | None
    way: str | None
    mesh: int


def fill(
    loops: Curves | str | PathLike[str] | Iterable[Any] | None = None,
    *,
    faces: Iterable[Sequence[str]] | None = None,
    curves: Mapping[tuple[str, str], npt.ArrayLike] | None = None,
    vertices: Mapping[str, npt.ArrayLike | None] | None = None,
    free: Iterable[str] = (),
    degree: int | None = None,
    energy: str = "area",
    tolerance: float = 1e-9,
    rim_tolerance: float | None = None,
    weld: float | None = None,
    corner_angle: float | None = None,
    bound: bool = False,
    layers: int = 0,
    accuracy: float | None = None,
    way: str | None = None,
    name: str = "",
    progress: Told | None = None,
) -> Surface:
    """The surface of least area in loops, or of the faces of a graph of curves.

    Args:
        loops: one loop, spanned by a disc, or two, spanned by an annulus, as a list. A loop is a closed polyline, shape (k, 3), cut
            at its corners and smooth between them, which may stand by itself; or a list of its sides: control points (n + 1, 3)
            of Bézier curves, or :class:`Curve`. Or the curves of a file: its path, or what :func:`from_file` gave; three and more that meet in a
            point make a graph, whose faces are found.
        faces: instead of loops, faces by the names of their vertices, three or more each, in order round. Two that follow one
            another and no curve joins get a free edge, found with the surface.
        curves: for faces, control points (n + 1, 3) by the names of the vertices at the ends.
        vertices: for faces, the places (3,) of vertices that no curve ends in; None where the surface is to find it.
        free: for faces, the names of vertices whose places are only where they start.
        degree: of every patch, 1 to 24. By default 6, or that of the curves where it is higher.
        energy: what is minimised, ``"area"`` or ``"dirichlet"``.
        tolerance: the relative decrease of the area that counts as none.
        rim_tolerance: how far the rim may pass from samples, a length; by default a ten-thousandth of the size.
        weld: how far apart ends may lie to be one point, a length.
        corner_angle: turn in degrees above which a polyline has a corner; by default 44.
        bound: whether a lower bound of the least area is proved, too: :attr:`Surface.lower_bound`.
        layers: 1 for a layer of smaller patches around the corners where a least area is not smooth.
        accuracy: the degree rises, to 14 at most, until the area is estimated to lie less than this share above the least, and
            corners that hold it up get a layer.
        way: how a loop is cut: ``"grid"``, ``"midpoint"``, ``"ring"``, ``"turned-ring"``, ``"parts"``; by default whatever leads
            to the best surface.
        name: of the surface.
        progress: called with (what is done, steps, of how many) a few times a second.

    Raises:
        BoundaryError: the arrays hold no points, the curves make no boundary.
        MethodError: no surface was found.

    >>> import numpy as np, plateau_patches as pp
    >>> t = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    >>> film = pp.fill([np.stack([np.cos(t), np.sin(t), 0.3 * np.cos(2 * t)], axis=1)], degree=6)
    >>> len(film.faces), film.kink.max < 0.01, film.faces[0].net.shape
    (5, True, (7, 7, 3))

    Two squares that share an edge, each a film:

    >>> corners = {"a": (0, 0, 0), "b": (1, 0, 0), "c": (1, 1, 0), "d": (0, 1, 0), "e": (1, 1, 1), "f": (0, 1, 1)}
    >>> ends = ["ab", "bc", "cd", "da", "ce", "ef", "fd"]
    >>> curves = {(a, b): [corners[a], corners[b]] for a, b in ends}
    >>> step = pp.fill(faces=["abcd", "dcef"], curves=curves, degree=3)
    >>> round(step.area, 9)
    2.0
    """
    if energy not in ("area", "dirichlet"):
        raise BoundaryError(f'energy {energy!r} is not offered over loops and faces; give "area" or "dirichlet"')
    if degree is not None:
        degree = whole(degree, "degree", 1, _HIGHEST)
    layers = whole(layers, "the number of layers", 0, 1)
    for what, share in (("tolerance", tolerance), ("accuracy", accuracy)):
        if share is not None and not 1e-12 <= number(share, what) <= 1e-2:
            raise BoundaryError(f"{what} {share} is not offered; give one from 1e-12 to 1e-2")
    lengths = {"rim_tolerance": rim_tolerance, "weld": weld, "corner_angle": corner_angle}
    rim_tolerance, weld, corner_angle = (None if x is None else number(x, what) for what, x in lengths.items())
    if energy != "area" and (layers or accuracy is not None):
        raise BoundaryError('layers and accuracy are for energy "area"')
    called = str(name) or ("Least area" if energy == "area" else "Dirichlet")
    options = Options(
        called, degree, energy, tolerance, rim_tolerance, weld, corner_angle, bool(bound), layers, accuracy, way, 16
    )
    if (loops is None) == (faces is None):
        raise BoundaryError("give either loops or faces")
    if faces is not None:
        return Surface(_of_faces(faces, curves or {}, vertices or {}, {str(vertex) for vertex in free}, options, progress))
    if curves is not None or vertices is not None:
        raise BoundaryError("curves and vertices belong to faces; loops are given by themselves")
    if isinstance(loops, (str, PathLike)):
        loops = from_file(loops)
    assert loops is not None
    notes = list(loops.notes) if isinstance(loops, Curves) else []
    all_curves = list(loops) if isinstance(loops, Curves) else _curves(loops)
    if not all_curves:
        raise BoundaryError("there is no loop")
    handle, more = _engine.fill_loops(all_curves, options, progress)
    unit = loops.unit if isinstance(loops, Curves) else None
    return Surface(handle, warnings=notes + more, unit=unit)


def _curves(loops: Any) -> list[Curve]:
    found = []
    if _is_one(loops):
        loops = [loops]
    try:
        loops = list(loops)
    except TypeError:
        raise BoundaryError(f"loops are a list of loops, not {loops!r}") from None
    for k, loop in enumerate(loops):
        if isinstance(loop, Curve):
            found.append(loop)
        elif _is_polyline(loop):
            polyline = points(loop, f"loops[{k}]")
            if len(polyline) < 3:
                raise BoundaryError(
                    f"loops[{k}] has {len(polyline)} points; a loop has at least 3. A loop of sides is a list in the list: [[side, side, …]]"
                )
            found.append(Curve.polyline(polyline, closed=True))
        else:
            found.extend(_side(side, f"loops[{k}][{s}]") for s, side in enumerate(loop))
    return found


def _side(side: Any, what: str) -> Curve:
    return side if isinstance(side, Curve) else Curve.bezier(points(side, what))


def _is_one(loops: Any) -> bool:
    """Whether it is one polyline: rows of numbers."""
    try:
        array = np.asarray(loops)
    except ValueError:
        return False
    return array.ndim == 2 and array.dtype.kind in "fiu"


def _is_polyline(loop: Any) -> bool:
    """Whether the parts of a loop are points, not sides."""
    if isinstance(loop, np.ndarray) or not isinstance(loop, (list, tuple)):
        return np.ndim(loop) != 3
    return not any(isinstance(part, Curve) or np.ndim(part) == 2 for part in loop)


def _of_faces(
    faces: Iterable[Sequence[str]],
    curves: Mapping[tuple[str, str], npt.ArrayLike],
    vertices: Mapping[str, npt.ArrayLike | None],
    free: set[str],
    options: Options,
    progress: Told | None,
) -> _engine.Surface:
    if not isinstance(curves, Mapping) or not all(isinstance(ends, (tuple, str)) and len(ends) == 2 for ends in curves):
        raise BoundaryError('curves are given by the vertices at their ends, as in {("a", "b"): [[0, 0, 0], [1, 0, 0]]}')
    # Any names will do, as in the numbers of the rows of an array.
    all_faces = [[str(vertex) for vertex in face] for face in faces]
    places: dict[str, tuple[float, float, float] | None] = {}
    for vertex in (vertex for face in all_faces for vertex in face):
        places.setdefault(vertex, None)
    for vertex, place in vertices.items():
        if place is not None:
            (row,) = points([place], f"vertices[{vertex!r}]", least=1)
            places[str(vertex)] = (float(row[0]), float(row[1]), float(row[2]))
    between = [(str(a), str(b), points(side, f"curves[{a!r}, {b!r}]")) for (a, b), side in curves.items()]
    # A vertex at the end of a curve lies there, whatever it is given as.
    given = [(vertex, place, place is not None and vertex not in free) for vertex, place in places.items()]
    return _engine.fill_faces(given, between, all_faces, options, progress)
