"""Rhino's files, in and out, as rhino3dm itself writes and reads them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import plateau_patches as pp

rhino3dm = pytest.importorskip("rhino3dm")

SQUARE = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 1.0), (0.0, 1.0, 0.0)]
# The area of the skew square, by Schwarz's formula.
SKEW = 1.279261571171


def at(*place: float) -> Any:
    return rhino3dm.Point3d(*map(float, place))


def lines(corners: list[tuple[float, ...]]) -> list[Any]:
    return [rhino3dm.LineCurve(at(*a), at(*b)) for a, b in zip(corners, corners[1:] + corners[:1])]


def written(path: Path, *geometry: Any) -> Path:
    model = rhino3dm.File3dm()
    for item in geometry:
        model.Objects.Add(item, rhino3dm.ObjectAttributes())
    assert model.Write(str(path), 7)
    return path


def test_curves_of_every_kind_bound_one_film(tmp_path: Path) -> None:
    arc = rhino3dm.ArcCurve.CreateFromArc(rhino3dm.Arc(at(2, 0, 0), at(3, 1, 0), at(2, 2, 0)))
    polyline = rhino3dm.Polyline(3)
    for place in ((2, 2, 0), (1, 2, 0), (0, 2, 0)):
        polyline.Add(*map(float, place))
    spline = rhino3dm.NurbsCurve.Create(False, 3, [at(0, y, 0) for y in (2.0, 1.7, 1.0, 0.5, 0.0)])
    path = written(
        tmp_path / "mixed.3dm", arc, rhino3dm.LineCurve(at(0, 0, 0), at(2, 0, 0)), spline, rhino3dm.PolylineCurve(polyline)
    )
    curves = pp.from_file(path)
    assert [curve.kind for curve in curves] == ["spline", "spline", "spline", "polyline"] and curves.notes == []
    # A square of side 2 and half a disc.
    assert pp.fill(path, degree=8).area == pytest.approx(4.0 + np.pi / 2.0, rel=1e-9)


def test_a_curve_of_several_parts_has_their_corners(tmp_path: Path) -> None:
    joined = rhino3dm.PolyCurve()
    for part in lines(SQUARE):
        joined.Append(part)
    path = written(tmp_path / "joined.3dm", joined)
    assert len(pp.from_file(path)) == 4
    assert pp.fill(path, degree=8).area == pytest.approx(SKEW, rel=1e-9)


def test_closed_splines_circles_and_polylines_are_loops(tmp_path: Path) -> None:
    t = np.linspace(0.0, 2.0 * np.pi, 12, endpoint=False)
    wave = rhino3dm.NurbsCurve.Create(True, 3, [at(np.cos(a), np.sin(a), 0.3 * np.cos(2.0 * a)) for a in t])
    film = pp.fill(written(tmp_path / "wave.3dm", wave))
    assert film.figures["rim_deviation"] < 1e-9 and 3.0 < film.area < 3.2
    ring = rhino3dm.ArcCurve.CreateFromCircle(rhino3dm.Circle(at(0, 0, 0), 2.0))
    assert pp.fill(written(tmp_path / "ring.3dm", ring)).area == pytest.approx(4.0 * np.pi, rel=1e-9)
    closed = rhino3dm.Polyline(5)
    for corner in [*SQUARE, SQUARE[0]]:
        closed.Add(*corner)
    assert pp.fill(written(tmp_path / "closed.3dm", rhino3dm.PolylineCurve(closed)), degree=8).area == pytest.approx(SKEW)


def test_what_is_hidden_is_passed_over_and_blocks_stand_in_their_places(tmp_path: Path) -> None:
    model = rhino3dm.File3dm()
    plain = rhino3dm.ObjectAttributes()
    model.InstanceDefinitions.Add("frame", "", "", "", at(0, 0, 0), tuple(lines(SQUARE)), (plain,) * 4)
    block = model.InstanceDefinitions.FindIndex(0)
    model.Objects.AddInstanceObject(rhino3dm.InstanceReference(block.Id, rhino3dm.Transform.Scale(at(0, 0, 0), 2.0)))
    layer = rhino3dm.Layer()
    layer.Name, layer.Visible = "construction", False
    unseen = rhino3dm.ObjectAttributes()
    unseen.LayerIndex = model.Layers.Add(layer)
    model.Objects.AddCurve(rhino3dm.LineCurve(at(0, 0, 0), at(5, 5, 5)), unseen)
    model.Write(str(tmp_path / "block.3dm"), 7)
    film = pp.fill(tmp_path / "block.3dm", degree=8)
    assert film.area == pytest.approx(4.0 * SKEW) and any("hidden, 1 of them" in warning for warning in film.warnings)


def test_surfaces_alone_are_filled_in_their_free_edges(wave: np.ndarray, tmp_path: Path) -> None:
    film = pp.fill(wave, degree=5)
    told = film.save(tmp_path / "film.3dm")
    assert told == f"a group of {len(film.faces)} NURBS surfaces, the patches themselves; in millimetres"
    model = rhino3dm.File3dm.Read(str(tmp_path / "film.3dm"))
    assert len(model.Groups) == 1 and all(item.Attributes.GroupCount == 1 for item in model.Objects)
    for item, face in zip(model.Objects, film.faces, strict=True):
        assert item.Geometry.IsValid
        point = item.Geometry.PointAt(0.3, 0.8)
        assert np.allclose([point.X, point.Y, point.Z], face.evaluate(0.3, 0.8), atol=1e-14)
    # The inner edges are those of two patches; what is left is the rim, cut where patches meet.
    again = pp.from_file(tmp_path / "film.3dm")
    assert len(again) == 4 and "free edges" in again.notes[0]
    assert pp.fill(again, degree=5).area == pytest.approx(film.area, rel=1e-12)
    assert again.unit == "mm" and film.save(tmp_path / "film.3dm", unit="m").endswith("; in metres")
    assert pp.from_file(tmp_path / "film.3dm").unit == "m"
    with pytest.raises(pp.FormatError, match="'us-ft' is no unit of 3DM"):
        film.save(tmp_path / "film.3dm", unit="us-ft")
    cylinder = rhino3dm.Cylinder(rhino3dm.Circle(at(0, 0, 0), 1.0), 0.5)
    path = written(tmp_path / "cylinder.3dm", rhino3dm.Brep.CreateFromCylinder(cylinder, False, False))
    # Seams are no edges.
    assert len(pp.from_file(path)) == 2


def test_every_kind_of_surface_is_written(sides: dict[str, np.ndarray], tmp_path: Path) -> None:
    triangle = pp.triangle([[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0, 1, 1]], [[0, 1, 1], [0, 0, 0]], degree=4)
    for surface, within in (
        (pp.least_area(*sides.values(), degree=9), 1e-14),
        (pp.gt(*sides.values(), shape=(1, 2, 1, 2)), 2e-5),
        (pp.helicoid(1.0, 0.5, u_span=1.0, v_span=9.0), 2e-4),
        (triangle, 1e-14),
    ):
        told = surface.save(tmp_path / "x.3dm", tolerance=1e-5)
        assert told is not None and ("the patch itself" in told) == (within < 1e-12)
        (item,) = rhino3dm.File3dm.Read(str(tmp_path / "x.3dm")).Objects
        assert item.Geometry.IsValid and item.Attributes.Name == surface.name
        if surface.domain is None:
            found, expected = item.Geometry.PointAt(1.0, 0.25), surface.evaluate(0.0, 0.75)
            other = surface.evaluate(0.0, 0.25)
        else:
            (u0, u1), (v0, v1) = surface.domain
            assert item.Geometry.Domain(0).T1 == u1 or item.Geometry.Domain(0).T1 == 1.0
            shares = (0.3, 0.7)
            spans = [item.Geometry.Domain(k) for k in (0, 1)]
            found = item.Geometry.PointAt(*(s.T0 + share * (s.T1 - s.T0) for s, share in zip(spans, shares)))
            expected = other = surface.evaluate(u0 + shares[0] * (u1 - u0), v0 + shares[1] * (v1 - v0))
        point = [found.X, found.Y, found.Z]
        assert min(np.abs(expected - point).max(), np.abs(other - point).max()) < within


def test_what_cannot_be_read_or_written_is_said(wave: np.ndarray, tmp_path: Path) -> None:
    box = rhino3dm.Brep.CreateFromBoundingBox(rhino3dm.BoundingBox(at(0, 0, 0), at(1, 1, 1)))
    with pytest.raises(pp.BoundaryError, match="no curves and no surfaces with free edges: 1 other objects"):
        pp.from_file(written(tmp_path / "box.3dm", box))
    (tmp_path / "broken.3dm").write_bytes(b"3D Geometry File Format, and no more")
    with pytest.raises(pp.BoundaryError, match="rhino3dm cannot read"):
        pp.fill(tmp_path / "broken.3dm")
    with pytest.raises(FileNotFoundError):
        pp.fill(tmp_path / "none.3dm")
    with pytest.raises(IsADirectoryError):
        pp.fill(wave, degree=3).save(tmp_path, "3dm")
    assert {path.name for path in tmp_path.iterdir()} == {"box.3dm", "broken.3dm"}
