"""Rhino's files, by the library rhino3dm (the extra ``rhino``)."""

from __future__ import annotations

import importlib
import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .arrays import Floats
from .curves import Curve, Curves
from .errors import BoundaryError, FormatError

if TYPE_CHECKING:
    from .surface import Surface

# Share of their size within which edges of surfaces are the same.
_SAME = 1e-6

# Units by name, and what Rhino calls them; it has no feet of surveys.
_UNITS = {
    "mm": "Millimeters",
    "cm": "Centimeters",
    "m": "Meters",
    "inch": "Inches",
    "ft": "Feet",
    "um": "Microns",
    "dm": "Decimeters",
    "km": "Kilometers",
    "yd": "Yards",
}

# Blocks in blocks that are looked into.
_DEPTH = 32


def _rhino() -> Any:
    try:
        return importlib.import_module("rhino3dm")
    except ImportError:
        raise ImportError("3DM files need rhino3dm: pip install 'plateau_patches[rhino]'") from None


def load(path: Path) -> Curves:
    """The curves of a 3DM file that can be seen in it: lines, polylines, arcs, circles, splines, those of blocks in their places;
    where there are none, the free edges of its surfaces."""
    rhino = _rhino()
    model = rhino.File3dm.Read(str(path))
    if model is None:
        raise BoundaryError(f"{path.name}: rhino3dm cannot read this 3DM file")
    items = [item for item in model.Objects if not item.Attributes.IsInstanceDefinitionObject]
    unseen = {layer.Index for layer in model.Layers if not layer.Visible}
    visible = [i for i in items if i.Attributes.Visible and i.Attributes.LayerIndex not in unseen]
    found, hidden = list(_placed(rhino, model, visible)), len(items) - len(visible)
    curves = [part for geometry, name in found for part in _curves(rhino, geometry, name)]
    other = sum(not isinstance(geometry, rhino.Curve) for geometry, _ in found)
    notes = [f"{path.name}: objects that are hidden, {hidden} of them, were passed over"] if hidden else []
    if curves and other:
        notes.append(f"{path.name}: objects that are no curves, {other} of them, were passed over")
    if not curves:
        curves = _free_edges(rhino, found)
        notes.append(f"{path.name}: it holds no curves; these are the free edges of its surfaces")
    if not curves:
        raise BoundaryError(
            f"{path.name}: it holds no curves and no surfaces with free edges: {other} other objects, and {hidden} that are hidden"
        )
    stated = model.Settings.ModelUnitSystem
    return Curves(curves, notes, next((unit for unit, name in _UNITS.items() if getattr(rhino.UnitSystem, name) == stated), None))


def _placed(rhino: Any, model: Any, items: list[Any]) -> Iterator[tuple[Any, str]]:
    """What the items are, with their names; of blocks their parts, where they stand."""
    parts = {str(item.Attributes.Id): item for item in model.Objects}

    def opened(geometry: Any, name: str, depth: int) -> Iterator[tuple[Any, str]]:
        if not isinstance(geometry, rhino.InstanceReference):
            yield geometry, name
            return
        block = model.InstanceDefinitions.FindId(geometry.ParentIdefId)
        if block is None or depth == 0:
            return
        for part in (parts.get(str(key)) for key in block.GetObjectIds()):
            if part is None:
                continue
            for inner, called in opened(part.Geometry, part.Attributes.Name or name, depth - 1):
                placed = inner.Duplicate()
                # Circles and arcs are no more where a block is stretched.
                if isinstance(placed, rhino.Curve):
                    placed = placed.ToNurbsCurve()
                placed.Transform(geometry.Xform)
                yield placed, called

    for item in items:
        yield from opened(item.Geometry, item.Attributes.Name or "", _DEPTH)


def _curves(rhino: Any, geometry: Any, name: str) -> Iterator[Curve]:
    """A curve of Rhino, one by one where it is several in a row."""
    if isinstance(geometry, rhino.PolyCurve):
        for k in range(geometry.SegmentCount):
            yield from _curves(rhino, geometry.SegmentCurve(k), name)
    elif isinstance(geometry, rhino.PolylineCurve):
        rows = np.array([[p.X, p.Y, p.Z] for p in (geometry.Point(k) for k in range(geometry.PointCount))])
        yield Curve.polyline(rows, closed=bool(geometry.IsClosed), name=name)
    elif isinstance(geometry, rhino.Curve):
        spline = geometry.ToNurbsCurve()
        # Points are (wx, wy, wz, w); Rhino leaves out the first and the last knot.
        raw = np.array([[p.X, p.Y, p.Z, p.W] for p in (spline.Points[k] for k in range(len(spline.Points)))])
        inner = [spline.Knots[k] for k in range(len(spline.Knots))]
        rational = bool(spline.IsRational)
        rows = raw[:, :3] / raw[:, 3:] if rational else raw[:, :3]
        knots = [inner[0], *inner, inner[-1]]
        yield Curve.spline(rows, knots, spline.Degree, weights=raw[:, 3] if rational else None, name=name)


def _free_edges(rhino: Any, found: list[tuple[Any, str]]) -> list[Curve]:
    """The edges of surfaces and polysurfaces at which one face ends and no other begins, in whatever object."""
    edges: list[tuple[Curve, Floats]] = []
    for geometry, name in found:
        brep = geometry.ToBrep(False) if isinstance(geometry, rhino.Extrusion) else geometry
        if isinstance(brep, rhino.Surface):
            brep = rhino.Brep.CreateFromSurface(brep)
        if not isinstance(brep, rhino.Brep):
            continue
        uses: Counter[int] = Counter()
        for k in range(len(brep.Faces)):
            loops = brep.Faces[k].Loops
            for trims in (loops[j].Trims for j in range(len(loops))):
                uses.update(trims[i].EdgeIndex for i in range(len(trims)))
        for number, count in uses.items():
            # Sides that are one point have no edge; an edge of two faces, or a seam, is used twice.
            if number >= 0 and count == 1:
                edge = brep.Edges[number]
                span = edge.Domain
                at = (edge.PointAt(span.T0 + share * (span.T1 - span.T0)) for share in (0.0, 0.25, 0.5, 0.75, 1.0))
                places = np.array([[p.X, p.Y, p.Z] for p in at])
                edges.extend((curve, places) for curve in _curves(rhino, edge, name))
    if not edges:
        return []
    whole = np.concatenate([places for _, places in edges])
    near = _SAME * float(np.linalg.norm(whole.max(axis=0) - whole.min(axis=0)))

    def same(one: Floats, two: Floats) -> bool:
        return bool(min(np.abs(one - two).max(), np.abs(one - two[::-1]).max()) <= near)

    return [
        curve
        for k, (curve, places) in enumerate(edges)
        if not any(same(places, other) for j, (_, other) in enumerate(edges) if j != k)
    ]


def save(surface: Surface, path: Path, tolerance: float, unit: str | None = None) -> str:
    """Writes the patches of a surface as NURBS surfaces, in a group where they are several: edges they share have the same control
    points, so that Rhino's ``Join`` makes one polysurface of them."""
    rhino = _rhino()
    unit = unit or "mm"
    if unit not in _UNITS:
        raise FormatError(f"{unit!r} is no unit of 3DM files; give one of {', '.join(_UNITS)}")
    splines, deviation = surface._handle.splines(tolerance)
    model = rhino.File3dm()
    model.Settings.ModelUnitSystem = getattr(rhino.UnitSystem, _UNITS[unit])
    group = None
    if len(splines) > 1:
        group = rhino.Group()
        group.Name = surface.name
        model.Groups.Add(group)
        group = model.Groups.FindName(surface.name)
    for (degree_u, knots_u), (degree_v, knots_v), net in splines:
        attributes = rhino.ObjectAttributes()
        attributes.Name = surface.name
        if group is not None:
            attributes.AddToGroup(group.Index)
        model.Objects.Add(_nurbs(rhino, (degree_u, degree_v), (knots_u, knots_v), net), attributes)
    part = path.with_name(f".{path.name}.part")
    if path.is_dir():
        raise IsADirectoryError(f"{path}: is a directory")
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        if not model.Write(str(part), 7):
            raise OSError(f"{path}: rhino3dm could not write it")
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)
    count = "one NURBS surface" if len(splines) == 1 else f"a group of {len(splines)} NURBS surfaces"
    how = "the patch itself" if len(splines) == 1 else "the patches themselves"
    return f"{count}, {how if deviation is None else f'no point farther than {deviation:.2e} from the patch'}; in {_UNITS[unit].lower().replace('meters', 'metres')}"


def _nurbs(rhino: Any, degrees: tuple[int, int], knots: tuple[list[float], list[float]], net: Floats) -> Any:
    rows, columns = net.shape[:2]
    nurbs = rhino.NurbsSurface.Create(3, False, degrees[0] + 1, degrees[1] + 1, rows, columns)
    for into, values in ((nurbs.KnotsU, knots[0]), (nurbs.KnotsV, knots[1])):
        for k, knot in enumerate(values[1:-1]):
            into[k] = knot
    for i in range(rows):
        for j in range(columns):
            x, y, z = net[i, j]
            nurbs.Points[i, j] = rhino.Point4d(x, y, z, 1.0)
    return nurbs
