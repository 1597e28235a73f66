"""Rhino's files, by the library rhino3dm (the extra ``rhino``)."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .curves import Curve, Curves
from .errors import BoundaryError, FormatError

if TYPE_CHECKING:
    from .surface import Surface


def _rhino() -> Any:
    try:
        return importlib.import_module("rhino3dm")
    except ImportError:
        raise ImportError("3DM files need rhino3dm: pip install 'plateau_patches[rhino]'") from None


def load(path: Path) -> Curves:
    """The curves of a 3DM file, as its splines have them."""
    rhino = _rhino()
    if not path.exists():
        raise FileNotFoundError(f"{path}: no such file")
    model = rhino.File3dm.Read(str(path))
    if model is None:
        raise BoundaryError(f"{path.name}: is no 3DM file that rhino3dm reads")
    curves, other = [], 0
    for item in model.Objects:
        geometry, name = item.Geometry, item.Attributes.Name or ""
        if not isinstance(geometry, rhino.Curve):
            other += 1
            continue
        curves.append(_curve(rhino, geometry, name))
    if not curves:
        raise BoundaryError(f"{path.name}: holds no curves, but {other} other objects")
    notes = [f"{path.name}: {other} objects that are no curves were passed over"] if other else []
    return Curves(curves, notes)


def _curve(rhino: Any, geometry: Any, name: str) -> Curve:
    if isinstance(geometry, rhino.PolylineCurve):
        rows = np.array([[p.X, p.Y, p.Z] for p in (geometry.Point(k) for k in range(geometry.PointCount))])
        return Curve.polyline(rows, closed=bool(geometry.IsClosed), name=name)
    spline = geometry.ToNurbsCurve()
    # Points are (wx, wy, wz, w); Rhino leaves out the first and the last knot.
    raw = np.array([[p.X, p.Y, p.Z, p.W] for p in (spline.Points[k] for k in range(len(spline.Points)))])
    inner = [spline.Knots[k] for k in range(len(spline.Knots))]
    knots = [inner[0], *inner, inner[-1]]
    rational = bool(spline.IsRational)
    rows = raw[:, :3] / raw[:, 3:] if rational else raw[:, :3]
    return Curve.spline(rows, knots, spline.Degree, weights=raw[:, 3] if rational else None, name=name)


def save(surface: Surface, path: Path) -> str:
    """Writes the patches of a surface, each as one NURBS surface."""
    rhino = _rhino()
    patches = surface._record["patch"], surface._record["basis"]
    if surface.kind not in ("tensor", "complex") or patches[1] != "bernstein":
        raise FormatError(
            f"{path}: 3DM is written of tensor Bézier patches; this surface is {surface.kind} in the {patches[1]} basis: "
            "save it as STEP, which Rhino opens"
        )
    model = rhino.File3dm()
    for net in surface.nets:
        rows, columns = net.shape[:2]
        nurbs = rhino.NurbsSurface.Create(3, False, rows, columns, rows, columns)
        for knots, count in ((nurbs.KnotsU, rows), (nurbs.KnotsV, columns)):
            for k in range(count - 1):
                knots[k], knots[k + count - 1] = 0.0, 1.0
        for i in range(rows):
            for j in range(columns):
                x, y, z = net[i, j]
                nurbs.Points[i, j] = rhino.Point4d(x, y, z, 1.0)
        model.Objects.AddSurface(nurbs)
    if not model.Write(str(path), 7):
        raise OSError(f"{path}: rhino3dm could not write it")
    return f"{len(surface.nets)} NURBS surfaces, the patches themselves"
