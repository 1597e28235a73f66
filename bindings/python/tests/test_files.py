"""Files in and out, and other libraries."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import plateau_patches as pp

FORMATS = ["obj", "ply", "stl", "glb", "vtu", "vtu-bezier", "step", "stp"]


@pytest.mark.parametrize("extension", FORMATS)
def test_every_format_is_written(
    extension: str, sides: dict[str, np.ndarray], wave: np.ndarray, tmp_path: Path
) -> None:
    for k, surface in enumerate(
        [
            pp.gt(*sides.values(), shape=(1, 1, 1, 1)),
            pp.fill([wave], degree=4),
            pp.triangle([[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0, 1, 1]], [[0, 1, 1], [0, 0, 0]]),
        ]
    ):
        path = tmp_path / f"{k}.{'bezier.vtu' if extension == 'vtu-bezier' else extension}"
        surface.save(path, n=8)
        assert path.stat().st_size > 500
        again = tmp_path / f"{k}.data"
        surface.save(str(again), extension.upper(), n=8)
        if extension not in ("step", "stp"):
            assert again.read_bytes() == path.read_bytes()


def test_what_cannot_be_written_is_said(sides: dict[str, np.ndarray], tmp_path: Path) -> None:
    patch = pp.dirichlet(*sides.values())
    with pytest.raises(pp.FormatError, match="'blend' is no format of surfaces; give one of obj, .*3dm"):
        patch.save(tmp_path / "x.blend")
    with pytest.raises(pp.FormatError, match="no extension"):
        patch.save(tmp_path / "x")
    with pytest.raises(OSError, match="directory"):
        patch.save(tmp_path, "obj")
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="file"):
        patch.save(tmp_path / "file" / "x.obj")
    (tmp_path / "file").unlink()
    assert list(tmp_path.iterdir()) == []


def test_step_holds_a_fitted_surface_within_the_tolerance(sides: dict[str, np.ndarray], tmp_path: Path) -> None:
    patch = pp.gt(*sides.values(), shape=(1, 1, 1, 1))
    told = patch.save(tmp_path / "x.step", tolerance=1e-4)
    assert told is not None and "deviat" in told or "within" in str(told) or "from the patch" in str(told)


def test_curves_are_read_from_every_format(tmp_path: Path) -> None:
    table = tmp_path / "loop.csv"
    table.write_text("x,y,z\n0,0,0\n1,0,0\n1,1,1\n0,1,0\n")
    lines = tmp_path / "loop.obj"
    lines.write_text("v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nl 3 4\nl 1 2\nl 1 4\nl 2 3\n")
    dxf = tmp_path / "loop.dxf"
    corners = ["0 0 0", "1 0 0", "1 1 1", "0 1 0"]
    entities = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        ends = [f"{10 * (k // 3 * 0) + code}\n{x}" for k, (code, x) in enumerate(zip((10, 20, 30), a.split()))]
        ends += [f"{code}\n{x}" for code, x in zip((11, 21, 31), b.split())]
        entities.append("0\nLINE\n8\n0\n" + "\n".join(ends))
    dxf.write_text("0\nSECTION\n2\nENTITIES\n" + "\n".join(entities) + "\n0\nENDSEC\n0\nEOF\n")
    step = tmp_path / "patch.step"
    pp.fill([[[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]], degree=6).save(step)
    areas = []
    for path in (table, lines, dxf):
        curves = pp.from_file(path)
        assert len(curves) >= 1 and all(curve.points.shape[1] == 3 for curve in curves)
        areas.append(pp.fill(curves, degree=6).area)
        assert pp.fill(path, degree=6).area == areas[-1]
    assert max(areas) - min(areas) < 1e-12
    # The edges of the patch that was written are splines of its degree.
    assert {curve.degree for curve in pp.from_file(step)} == {6}
    assert pp.fill(step, degree=6).area == pytest.approx(areas[0], abs=1e-9)


def test_a_unit_that_is_known_goes_into_the_files(tmp_path: Path) -> None:
    rim = tmp_path / "rim.csv"
    rim.write_text("# inches\nx,y,z\n0,0,0\n1,0,0\n1,1,1\n0,1,0\n")
    assert pp.from_file(rim).unit == "inch"
    film = pp.fill(rim, degree=3)
    assert film.unit == "inch" and pickle.loads(pickle.dumps(film)).unit == "inch"
    ran = pp.run('title = "x"\n[boundary]\npolygon = [[0,0,0],[1,0,0],[1,1,1],[0,1,0]]\n[[method]]\nname = "m"\nenergy = "area"\n[output]\nstep-unit = "inch"\n')
    for surface in (film, ran["m"], pickle.loads(pickle.dumps(ran))["m"]):
        told = surface.save(tmp_path / "x.glb")
        assert told == "in metres, as glTF is: 1 inch became 0.0254"
        assert b'"scale":[0.0254,0.0254,0.0254]' in (tmp_path / "x.glb").read_bytes()
        surface.save(tmp_path / "x.step")
        assert "CONVERSION_BASED_UNIT('INCH'" in (tmp_path / "x.step").read_text()
        surface.save(tmp_path / "y.glb", unit="m")
        assert b'"scale"' not in (tmp_path / "y.glb").read_bytes()
    with pytest.raises(pp.FormatError, match='"parsec" is no unit of length; give one of mm, cm'):
        film.save(tmp_path / "x.step", unit="parsec")


def test_what_is_no_file_of_curves_is_said(tmp_path: Path) -> None:
    broken = tmp_path / "broken.csv"
    broken.write_text("x,y,z\n0,0,0\n1,zero,0\n")
    with pytest.raises(pp.BoundaryError, match="line 3"):
        pp.from_file(broken)
    with pytest.raises(FileNotFoundError):
        pp.from_file(tmp_path / "none.csv")
    picture = tmp_path / "x.png"
    picture.write_bytes(b"\x89PNG\r\n")
    with pytest.raises(pp.BoundaryError, match="picture"):
        pp.fill(picture)


def test_circles_splines_and_sides_in_any_order_are_filled() -> None:
    disc = pp.fill([pp.Curve.circle([0, 0, 1], [0, 0, 2], 2.0)])
    assert disc.area == pytest.approx(4.0 * np.pi, rel=1e-5)
    catenoid = pp.fill(
        [pp.Curve.circle([0, 0, -0.5], [0, 0, 1], 1.0), pp.Curve.circle([0, 0, 0.5], [0, 0, 1], 1.0)], degree=6
    )
    # The stable catenoid between unit circles one apart: c cosh(1/2c) = 1.
    c = 0.8483379
    assert catenoid.area == pytest.approx(np.pi * c * (1.0 + c * np.sinh(1.0 / c)), rel=1e-4)
    a, b, d = [0, 0, 0], [2, 0, 0], [0, 2, 1]
    sides = [[d, [1, 1, 0], b], [a, [1, -1, 0], b], [d, a]]
    one, two = pp.fill([sides]), pp.fill([[sides[1], sides[0][::-1], sides[2]]])
    assert one.area == pytest.approx(two.area, rel=1e-8)


def test_faces_share_an_edge_that_is_found() -> None:
    # Three films meet in a line, in equal angles: a Y seen from above.
    corner = {f"{level}{k}": (np.cos(2 * k * np.pi / 3), np.sin(2 * k * np.pi / 3), level) for level in (0, 1) for k in range(3)}
    curves = {(f"0{k}", f"1{k}"): [corner[f"0{k}"], corner[f"1{k}"]] for k in range(3)}
    curves |= {(f"{level}{k}", f"{level}m"): [corner[f"{level}{k}"], (0.0, 0.0, level)] for level in (0, 1) for k in range(3)}
    film = pp.fill(faces=[[f"0{k}", f"1{k}", "1m", "0m"] for k in range(3)], curves=curves, degree=3)
    assert film.area == pytest.approx(3.0, rel=1e-9)
    with pytest.raises(pp.BoundaryError, match="either loops or faces"):
        pp.fill()
    with pytest.raises(pp.BoundaryError, match="no vertex|none"):
        pp.fill(faces=[["a", "b", "c"]], curves={("a", "x"): [[0, 0, 0], [1, 0, 0]]})


def test_other_libraries_take_the_mesh(wave: np.ndarray, tmp_path: Path) -> None:
    film = pp.fill([wave], degree=4)
    pytest.importorskip("trimesh")
    mesh = film.to_trimesh(12)
    assert mesh.area == pytest.approx(film.area, rel=1e-2) and not mesh.is_watertight
    assert len(mesh.vertices) == len(film.mesh(12).vertices)
    meshio = pytest.importorskip("meshio")
    film.to_meshio(12).write(tmp_path / "x.vtk", binary=True)
    assert len(meshio.read(tmp_path / "x.vtk").points) == len(mesh.vertices)


def test_pyvista_takes_the_mesh(wave: np.ndarray) -> None:
    pytest.importorskip("pyvista")
    film = pp.fill(wave, degree=4)
    mesh = film.to_trimesh(12)
    data = film.to_pyvista(12)
    assert data.n_cells == len(mesh.faces) and data.area == pytest.approx(mesh.area)


def test_pictures_pages_and_plots(sides: dict[str, np.ndarray], wave: np.ndarray, tmp_path: Path) -> None:
    for surface in (pp.least_area(*sides.values(), degree=4), pp.fill([wave], degree=4)):
        assert surface.picture.startswith("<svg") and "<svg" in surface._repr_html_()
        assert f"{surface.area:.12g}" in surface._repr_html_()
        page = surface.report()
        assert page.startswith("<!DOCTYPE html>") and surface.name in page
        page.save(tmp_path / "page.html")
        assert (tmp_path / "page.html").read_text(encoding="utf-8") == page
        assert "iframe" in page._repr_html_() and len(repr(page)) < 100
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = pp.fill([wave], degree=4).plot(n=6, cmap="viridis")
    axes.figure.savefig(tmp_path / "plot.png")
    assert (tmp_path / "plot.png").stat().st_size > 1000
