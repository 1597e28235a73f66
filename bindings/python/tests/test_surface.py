"""Evaluation and meshes."""

from __future__ import annotations

import tracemalloc
from math import comb

import numpy as np
import pytest

import plateau_patches as pp


def bernstein(net: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The Bézier patch of a net by its definition."""

    def basis(degree: int, t: np.ndarray) -> np.ndarray:
        return np.stack([comb(degree, k) * t**k * (1.0 - t) ** (degree - k) for k in range(degree + 1)], axis=-1)

    m, n = net.shape[0] - 1, net.shape[1] - 1
    return np.einsum("...i,...j,ijk->...k", basis(m, u), basis(n, v), net)


def test_points_are_those_of_the_net(sides: dict[str, np.ndarray]) -> None:
    patch = pp.least_area(*sides.values(), degree=7)
    u, v = np.linspace(0.0, 1.0, 7)[:, None], np.linspace(0.0, 1.0, 5)
    found = patch.evaluate(u, v)
    assert found.shape == (7, 5, 3)
    assert np.allclose(found, bernstein(patch.net, *np.broadcast_arrays(u, v)), atol=1e-13)
    assert patch.evaluate(0.5, 0.25).shape == (3,) and patch.evaluate([], []).shape == (0, 3)
    assert (patch.evaluate(0.5, [0.25])[0] == patch.evaluate(0.5, 0.25)).all()
    # A corner of the frame is met to the last digit.
    assert patch.evaluate(0, 1).tolist() == sides["u0"][-1].tolist()


def test_many_points_have_the_bits_of_each(sides: dict[str, np.ndarray]) -> None:
    patch = pp.gt(*sides.values(), shape=(1, 2, 2, 1))
    random = np.random.default_rng(1)
    u, v = random.random(20_000), random.random(20_000)
    many = patch.evaluate(u, v)
    assert all((many[k] == patch.evaluate(u[k], v[k])).all() for k in range(0, 20_000, 997))


def test_normals_and_curvatures_are_those_of_the_surface(sides: dict[str, np.ndarray]) -> None:
    patch = pp.least_area(*sides.values(), degree=8)
    u, v = np.meshgrid(np.linspace(0.1, 0.9, 5), np.linspace(0.1, 0.9, 4), indexing="ij")
    by_u, by_v = patch.derivatives(u, v)
    h = 1e-6
    assert np.allclose(by_u, (patch.evaluate(u + h, v) - patch.evaluate(u - h, v)) / (2 * h), atol=1e-7)
    assert np.allclose(by_v, (patch.evaluate(u, v + h) - patch.evaluate(u, v - h)) / (2 * h), atol=1e-7)
    cross = np.cross(by_u, by_v)
    normals = patch.normals(u, v)
    assert np.allclose(normals, cross / np.linalg.norm(cross, axis=-1, keepdims=True), atol=1e-12)
    assert patch.mean_curvature(u, v).shape == u.shape
    assert np.abs(patch.mean_curvature(u, v)).max() < 0.05 < np.abs(patch.gauss_curvature(u, v)).max()


def test_a_surface_has_no_curvature_where_it_is_singular() -> None:
    apex = [[0.0, 0.0, 1.0]] * 2
    patch = pp.discrete_coons(apex, [[0, 0, 0], [1, 0, 0]], [[0, 0, 1], [0, 0, 0]], [[0, 0, 1], [1, 0, 0]])
    assert np.isnan(patch.normals(0.0, 0.5)).all() and np.isnan(patch.mean_curvature(0.0, 0.5))
    assert np.isfinite(patch.mesh(4).normals).all()


def test_a_mesh_has_the_area_of_its_surface(sides: dict[str, np.ndarray], wave: np.ndarray) -> None:
    for surface in (
        pp.least_area(*sides.values(), degree=6),
        pp.triangle([[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0, 1, 1]], [[0, 1, 1], [0, 0, 0]], degree=3),
        pp.fill([wave]),
        pp.helicoid(1.0, 0.5, u_span=1.0, v_span=9.0),
    ):
        mesh = surface.mesh(60)
        corners = mesh.vertices[mesh.faces]
        doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert 0.5 * np.linalg.norm(doubled, axis=1).sum() == pytest.approx(surface.area, rel=1e-2)
        # Triangles turn as their normals say.
        assert (np.einsum("ij,ij->i", doubled, mesh.normals[mesh.faces[:, 0]]) > 0.0).mean() > 0.99
        assert mesh.faces.max() == len(mesh.vertices) - 1
        assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1.0)


def test_a_mesh_of_several_patches_is_watertight(wave: np.ndarray) -> None:
    film = pp.fill([wave])
    mesh = film.mesh(8)
    assert mesh.patches is not None and set(mesh.patches.tolist()) == set(range(len(film.faces)))
    edges = np.sort(mesh.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, uses = np.unique(edges, axis=0, return_counts=True)
    # Every edge belongs to two triangles, but those of the rim.
    assert set(uses.tolist()) == {1, 2} and len(np.unique(mesh.vertices, axis=0)) == len(mesh.vertices)


def test_faces_meet_and_say_where_they_lie(wave: np.ndarray) -> None:
    film = pp.fill([wave], degree=5)
    with pytest.raises(ValueError, match=f"{len(film.faces)} patches"):
        film.evaluate(0.5, 0.5)
    with pytest.raises(ValueError, match="take nets"):
        _ = film.net
    places: dict[str, np.ndarray] = {}
    for face in film.faces:
        for name, (u, v) in zip(face.vertices, ((0, 0), (1, 0), (1, 1), (0, 1))):
            point = face.evaluate(u, v)
            assert (places.setdefault(name, point) == point).all()
    assert len(places) > 4
    with pytest.raises(ValueError):
        film.faces[0].net[0, 0, 0] = 1.0


def test_a_fine_mesh_takes_less_than_twice_its_arrays(sides: dict[str, np.ndarray]) -> None:
    import resource
    import subprocess
    import sys

    code = f"""
import resource, numpy as np, plateau_patches as pp
patch = pp.dirichlet(*{[side.tolist() for side in sides.values()]!r})
patch.mesh(8)
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
mesh = patch.mesh(500)
after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
print(1024 * (after - before), sum(array.nbytes for array in mesh if array is not None))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    peak, arrays = map(int, done.stdout.split())
    assert resource.RUSAGE_SELF == 0 and arrays > 20e6
    assert peak < 2 * arrays, (peak, arrays)


def test_a_thousand_films_leave_nothing_behind() -> None:
    loop = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 0.0]])

    def resident() -> int:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * 4096

    for _ in range(100):
        pp.fill([loop], degree=3)
    tracemalloc.start()
    python, whole = tracemalloc.get_traced_memory()[0], resident()
    for _ in range(1000):
        pp.fill([loop], degree=3)
    # Less than a kilobyte a film of either kind: a film is several.
    assert tracemalloc.get_traced_memory()[0] - python < 100_000
    assert resident() - whole < 1_000_000
    tracemalloc.stop()
