"""Surfaces that were found."""

from __future__ import annotations

import importlib
import json
from functools import cached_property
from html import escape
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _engine
from .arrays import Floats, number, parameters, whole
from .errors import BoundaryError, FormatError
from .mesh import Mesh
from .report import Report

# Entries of a record that are geometry or have attributes of their own.
_NO_FIGURES = {"name", "net", "faces", "pieces", "domain", "files", "warnings", "patch", "basis", "vertices", "lower_bound_proof"}


class Kink(NamedTuple):
    """Angles between the normals of neighbouring patches across the edges they share, in radians."""

    max: float
    """The largest."""
    rms: float
    """The root of the mean of their squares over the length of the edges."""


class LowerBound(NamedTuple):
    """A proved bound of the least area."""

    value: float
    """The area, length². Proved: whatever rounding did is taken off."""
    holds_for: str
    """Which surfaces are meant."""


class Face:
    """A patch of a surface."""

    def __init__(self, handle: _engine.Surface, index: int, vertices: tuple[str, ...]) -> None:
        self._handle = handle
        self._index = index
        self.vertices = vertices
        """The names of its corners at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1); empty for patches by themselves."""

    @cached_property
    def net(self) -> Floats:
        """Control points: shape (m + 1, n + 1, 3), i with u and j with v, or ((n + 1)(n + 2)/2, 3) of a triangle, whose
        (i, j, k) are :attr:`Surface.indices`."""
        net = self._handle.nets()[self._index]
        net.flags.writeable = False
        return net

    @cached_property
    def domain(self) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """The ranges of u and of v; None stands for the triangle u, v ≥ 0, u + v ≤ 1."""
        domain = self._handle.domain()
        return None if domain is None else (domain[0], domain[1])

    def evaluate(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
        """Points at parameters. ``u`` and ``v`` broadcast; the result has their shape and 3 coordinates behind."""
        at, shape = parameters(u, v, self.domain)
        return self._handle.points(self._index, at).reshape(*shape, 3)

    def derivatives(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Floats, Floats]:
        """The derivatives by u and by v, each of the shape of :meth:`evaluate`."""
        at, shape = parameters(u, v, self.domain)
        by_u, by_v = self._handle.derivatives(self._index, at)
        return by_u.reshape(*shape, 3), by_v.reshape(*shape, 3)

    def normals(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
        """Unit normals, of the shape of :meth:`evaluate`; not a number where the patch is singular."""
        at, shape = parameters(u, v, self.domain)
        return self._handle.curvatures(self._index, at)[0].reshape(*shape, 3)

    def mean_curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Any:
        """Mean curvature, 1/length, of the shape that ``u`` and ``v`` broadcast to, of two numbers a number; not a number where
        there is none."""
        at, shape = parameters(u, v, self.domain)
        return self._handle.curvatures(self._index, at)[1].reshape(shape)[()]

    def gauss_curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Any:
        """Gauss curvature, 1/length², like :meth:`mean_curvature`."""
        at, shape = parameters(u, v, self.domain)
        return self._handle.curvatures(self._index, at)[2].reshape(shape)[()]

    def __repr__(self) -> str:
        points = "×".join(str(count) for count in self.net.shape[:-1])
        corners = f" of {', '.join(self.vertices)}" if self.vertices else ""
        return f"<Face {self._index}{corners}: {points} control points>"


class Surface:
    """A surface with its figures: one patch, or several that share edges.

    Lengths have the unit of the boundary, areas and energies its square, angles are in radians.

    >>> import plateau_patches as pp
    >>> saddle = pp.fill([[[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]], degree=6)
    >>> round(saddle.area, 6), saddle.area_error < 1e-9
    (1.279262, True)
    """

    def __init__(
        self,
        handle: _engine.Surface,
        title: str = "",
        warnings: list[str] | None = None,
        experiment: str = "",
        unit: str | None = None,
    ) -> None:
        self._handle = handle
        self._record: dict[str, Any] = json.loads(handle.record)
        self._title = title or str(self._record["name"])
        self._about = list(warnings or [])
        self.experiment = experiment
        """The experiment it comes of, which ``plateau run`` and :func:`run` take; empty where curves were filled directly."""

        self.unit = unit
        """What its numbers are, where the file of its curves or its experiment says so; :meth:`save` writes it."""

    @property
    def name(self) -> str:
        """The name of the method."""
        return str(self._record["name"])

    @property
    def kind(self) -> str:
        """``tensor``, ``triangle``, ``pieces`` (patches in rows that meet exactly) or ``complex`` (that share edges)."""
        return self._handle.kind

    @property
    def area(self) -> float:
        """The area, length²."""
        return float(self._record["area"])

    @property
    def area_error(self) -> float:
        """The error believed of :attr:`area`: of its quadrature, not of the surface as a minimum."""
        return float(self._record["area_error"])

    @property
    def figures(self) -> dict[str, Any]:
        """All figures, by their names in ``result.json``: energies and their errors, curvature, how the surface was found."""
        return {key: value for key, value in self._record.items() if key not in _NO_FIGURES}

    @property
    def warnings(self) -> list[str]:
        """What a reader must know before trusting the surface or its figures, one sentence each."""
        return [*self._about, *self._record.get("warnings", [])]

    @property
    def shape(self) -> tuple[float, ...] | None:
        """The shape parameters of bases that have them, those in u before those in v: (α1, α2, β1, β2) of the GT basis."""
        shape = self._record.get("shape")
        return None if shape is None else tuple(shape)

    @property
    def kink(self) -> Kink | None:
        """How far from smooth the patches meet; None where no two share a free edge."""
        kink = self._record.get("kink")
        return None if kink is None else Kink(kink["max"], kink["rms"])

    @property
    def second_variation(self) -> float | None:
        """The least second variation of the area along the normal, dimensionless: positive for a stable minimum, negative for
        a saddle. None where no area was minimised, or it cannot be trusted."""
        value = self._record.get("area_extremal", {}).get("second_variation")
        return None if value is None else float(value)

    @property
    def lower_bound(self) -> LowerBound | None:
        """What no surface with the same rim is below, where ``bound=True`` asked for it and it was proved; else a warning says why
        it was not.

        >>> import plateau_patches as pp
        >>> film = pp.fill([[[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]], degree=8, bound=True)
        >>> film.lower_bound.value < film.area < film.lower_bound.value + 1e-6, film.lower_bound.holds_for
        (True, 'every surface with this rim')
        """
        bound = self._record.get("lower_bound")
        return None if bound is None else LowerBound(bound, self._record["lower_bound_proof"]["holds_for"])

    @cached_property
    def faces(self) -> tuple[Face, ...]:
        """The patches, each with its ``net`` and ``evaluate``; one for a patch by itself."""
        if self.kind == "pieces":
            # Patches in rows are evaluated as one.
            return (Face(self._handle, 0, ()),)
        named = self._record.get("faces")
        if named is None:
            return (Face(self._handle, 0, ()),)
        return tuple(Face(self._handle, k, tuple(face["vertices"])) for k, face in enumerate(named))

    @property
    def nets(self) -> list[Floats]:
        """The control points of every patch."""
        return self._handle.nets()

    @property
    def net(self) -> Floats:
        """The control points of a single patch, see :attr:`Face.net`.

        Raises:
            BoundaryError: there are several patches; their nets are ``nets`` or ``faces[k].net``.
        """
        nets = self.nets
        if len(nets) != 1:
            raise BoundaryError(f"the surface has {len(nets)} patches: take nets, or faces[k].net")
        nets[0].flags.writeable = False
        return nets[0]

    @property
    def indices(self) -> npt.NDArray[np.uint32] | None:
        """Of a triangular patch: the (i, j, k), i + j + k = n, of every control point, shape ((n + 1)(n + 2)/2, 3)."""
        return self._handle.indices()

    @property
    def domain(self) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """The ranges of u and of v; None stands for the triangle u, v ≥ 0, u + v ≤ 1."""
        return self.faces[0].domain

    def _only_face(self) -> Face:
        if len(self.faces) != 1:
            raise BoundaryError(f"the surface has {len(self.faces)} patches: say which, as in faces[0].evaluate(u, v)")
        return self.faces[0]

    def evaluate(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
        """Points at parameters. ``u`` and ``v`` broadcast; the result has their shape and 3 coordinates behind.

        >>> import plateau_patches as pp
        >>> sphere = pp.helicoid(0.0, 1.0, u_span=1.0, v_span=1.0)
        >>> sphere.evaluate([[0.0], [1.0]], [0.0, 0.5, 1.0]).shape
        (2, 3, 3)
        """
        return self._only_face().evaluate(u, v)

    def derivatives(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Floats, Floats]:
        """The derivatives by u and by v, each of the shape of :meth:`evaluate`."""
        return self._only_face().derivatives(u, v)

    def normals(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
        """Unit normals, of the shape of :meth:`evaluate`; not a number where the patch is singular."""
        return self._only_face().normals(u, v)

    def mean_curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Any:
        """Mean curvature, 1/length, of the shape that ``u`` and ``v`` broadcast to, of two numbers a number; not a number where
        there is none."""
        return self._only_face().mean_curvature(u, v)

    def gauss_curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Any:
        """Gauss curvature, 1/length², like :meth:`mean_curvature`."""
        return self._only_face().gauss_curvature(u, v)

    def mesh(self, n: int = 48) -> Mesh:
        """A triangle mesh with ``n`` subdivisions of every side of every patch: 2n² triangles a rectangle, n² a triangle."""
        n = whole(n, "the number of subdivisions", 1, 4096)
        vertices, normals, at, mean, gauss, faces, patches = self._handle.mesh(n)
        return Mesh(vertices, faces, normals, at, mean, gauss, patches)

    def to_trimesh(self, n: int = 48) -> Any:
        """A ``trimesh.Trimesh`` of :meth:`mesh`, with its normals."""
        trimesh = _library("trimesh")
        mesh = self.mesh(n)
        return trimesh.Trimesh(mesh.vertices, mesh.faces, vertex_normals=mesh.normals, process=False)

    def to_meshio(self, n: int = 48) -> Any:
        """A ``meshio.Mesh`` of :meth:`mesh`, with normals and curvatures at its points."""
        meshio = _library("meshio")
        mesh = self.mesh(n)
        data = {
            "normals": mesh.normals,
            "mean_curvature": mesh.mean_curvature,
            "gauss_curvature": mesh.gauss_curvature,
        }
        return meshio.Mesh(mesh.vertices, [("triangle", mesh.faces)], point_data=data)

    def to_pyvista(self, n: int = 48) -> Any:
        """A ``pyvista.PolyData`` of :meth:`mesh`, with normals and curvatures at its points."""
        pyvista = _library("pyvista")
        mesh = self.mesh(n)
        threes = np.full((len(mesh.faces), 1), 3, dtype=np.int64)
        data = pyvista.PolyData(mesh.vertices, np.hstack([threes, mesh.faces.astype(np.int64)]).ravel())
        data["normals"] = mesh.normals
        data["mean_curvature"] = mesh.mean_curvature
        data["gauss_curvature"] = mesh.gauss_curvature
        return data

    def save(
        self,
        path: str | PathLike[str],
        format: str | None = None,
        *,
        n: int | None = None,
        tolerance: float = 1e-6,
        unit: str | None = None,
    ) -> str | None:
        """Writes the surface in the format of the file's extension, or in ``format``: ``obj``, ``ply``, ``stl``, ``glb``,
        ``vtu`` (meshes of ``n`` subdivisions a side: 48, or 16 of each of several patches), ``step``, ``vtu-bezier`` (files that
        end in ``.bezier.vtu``) and, with the extra ``rhino``, ``3dm`` (the surface itself, or a fit within ``tolerance`` of its size). The file is there whole or not at all; folders
        that are not there are made.

        ``unit`` says what the numbers are (``mm``, ``cm``, ``m``, ``inch``, ``ft``, ``um``, ``dm``, ``km``, ``yd``, ``us-ft``; by default
        :attr:`unit`): STEP and 3DM files say so, GLB is scaled to its metres.

        Returns:
            How the file holds the surface, where that takes saying: by a formula, or with less than all digits.

        Raises:
            FormatError: no such format, or it cannot hold the surface.
            OSError: the file system.
        """
        path = Path(fspath(path))
        wanted = (format or _engine.format_of(path.name) or path.suffix).lstrip(".").lower()
        if not 0.0 < number(tolerance, "tolerance") < 1.0:
            raise FormatError(f"tolerance {tolerance} is not offered: it is a share of the size")
        if n is None:
            n = 16 if self.kind == "complex" else 48
        n = whole(n, "the number of subdivisions", 1, 4096)
        if wanted == "3dm":
            from .rhino import save

            return save(self, path, tolerance, unit or self.unit)
        known = [*_engine.formats(), "stp", "3dm"]
        if wanted not in known:
            found = f"{wanted!r} is no format of surfaces" if wanted else f"{path} has no extension to tell the format by"
            raise FormatError(f"{found}; give one of {', '.join(known)}")
        return self._handle.write(path, wanted, n, tolerance, unit or self.unit)

    def _page(self) -> tuple[str, list[tuple[str, str, str]]]:
        return _engine.page(self._title, [self._handle], self.warnings, self.experiment)

    @property
    def picture(self) -> str:
        """A picture of the surface with its control points, as SVG."""
        pictures = {name: svg for name, _, svg in self._page()[1]}
        return pictures.get("surfaces", "")

    def report(self) -> Report:
        """The page: the surface to turn, its figures, its pictures, in one HTML file that needs nothing but itself."""
        return Report(self._page()[0])

    def plot(self, ax: Any = None, n: int = 32, **options: Any) -> Any:
        """Draws :meth:`mesh` into axes of matplotlib, new ones without ``ax``, and returns them; by pyvista where there is no
        matplotlib. ``options`` go to ``plot_trisurf`` or ``add_mesh``."""
        from .plotting import plot

        return plot(self, ax, n, options)

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th style='text-align:left'>{name}</th><td>{value}</td></tr>" for name, value in self._rows()
        )
        return f"<div>{self.picture}</div><table>{rows}</table>"

    def _rows(self) -> list[tuple[str, str]]:
        rows = [("area", f"{self.area:.12g} ± {self.area_error:.1e} length²"), ("patches", str(len(self.nets)))]
        if self.kink is not None:
            rows.append(("kink", f"at most {self.kink.max:.2e} rad"))
        if self.second_variation is not None:
            rows.append(("second variation", f"{self.second_variation:.6g}"))
        return [*rows, *(("warning", escape(warning)) for warning in self.warnings)]

    def __repr__(self) -> str:
        count = len(self.nets)
        patches = self.kind if count == 1 else f"{count} patches"
        return f"<Surface {self.name!r}: {patches}, area {self.area:.9g} ± {self.area_error:.1e}>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Surface):
            return NotImplemented
        return self._handle.record == other._handle.record and self.warnings == other.warnings

    def __hash__(self) -> int:
        return hash(self._handle.record)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._handle.record, self._title, self._about, self.experiment, self.unit)

    def __copy__(self) -> Surface:
        return self

    def __deepcopy__(self, _: object) -> Surface:
        # Nothing of it can change.
        return self


def _restored(record: str, title: str, warnings: list[str], experiment: str, unit: str | None = None) -> Surface:
    return Surface(_engine.Surface.restore(record), title, warnings, experiment, unit)


def _library(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise ImportError(f"{name} is not installed: pip install {name}") from None
