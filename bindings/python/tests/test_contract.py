"""What outside programs rely on."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import plateau_patches as pp


def test_the_snippet(sides: dict[str, np.ndarray], wave: np.ndarray, fixtures: Path, tmp_path: Path) -> None:
    u0, u1, v0, v1 = sides.values()
    patch = pp.least_area(u0, u1, v0, v1, degree=8)
    film = pp.fill([wave], degree=6)
    u = v = np.linspace(0.0, 1.0, 5)
    assert isinstance(patch.area, float) and 0.0 < patch.area_error < 1e-9
    assert patch.net.shape == (9, 9, 3) and patch.evaluate(u, v).shape == (5, 3)
    vertices, faces, *_ = patch.mesh(48)
    assert vertices.shape == (49 * 49, 3) and faces.shape == (2 * 48 * 48, 3)
    assert len(film.faces) > 1 and film.kink is not None and 0.0 < film.kink.rms <= film.kink.max < 0.1
    film.save(tmp_path / "x.step")
    assert (tmp_path / "x.step").read_text().startswith("ISO-10303-21;")
    result = pp.run(fixtures / "gallery" / "schwarz-d.toml")
    assert result["Least area"].area > 0.0


def test_figures_are_those_of_the_record(sides: dict[str, np.ndarray]) -> None:
    patch = pp.least_area(*sides.values(), degree=6)
    assert patch.figures["area"] == patch.area
    assert patch.figures["area_extremal"]["second_variation"] == patch.second_variation
    assert patch.second_variation is not None and patch.second_variation > 0.0
    assert patch.kink is None and patch.warnings == [] and len(patch.faces) == 1
    assert (patch.faces[0].net == patch.net).all()
    assert pp.dirichlet(*sides.values()).second_variation is None


def test_every_method_has_the_area_of_its_definition(sides: dict[str, np.ndarray]) -> None:
    least = pp.least_area(*sides.values(), degree=8)
    # The least area over these four parabolas, by the engine's own examples.
    assert least.area == pytest.approx(7.383505602602, rel=1e-7)
    others = [
        pp.dirichlet(*sides.values(), degree=8),
        pp.dirichlet(*sides.values(), degree=8, metric_steps=3),
        pp.extremal(*sides.values(), degree=8, energy="bending"),
        pp.extremal(*sides.values(), energy="laplacian"),
        pp.extremal(*sides.values(), energy="coons"),
        pp.mask(*sides.values(), alpha=-0.25, degree=4),
        pp.discrete_coons(*sides.values()),
    ]
    assert all(other.area > least.area - least.area_error for other in others)
    # The mask of weight −1/4 is the discrete Coons patch's, and so are the extremals of ∫‖x_uv‖² and the formula.
    coons = pp.discrete_coons(*sides.values())
    assert np.allclose(pp.mask(*sides.values()).net, coons.net, atol=1e-12)
    assert np.allclose(pp.extremal(*sides.values(), energy="coons").net, coons.net, atol=1e-12)
    assert others[1].area < others[0].area


def test_a_gt_patch_moves_its_boundary_and_a_search_is_repeatable(sides: dict[str, np.ndarray]) -> None:
    fixed = pp.gt(*sides.values(), shape=(1, 2, 1, 2))
    assert fixed.shape == (1.0, 2.0, 1.0, 2.0) and fixed.figures["boundary_deviation"] > 0.0
    settings = {"particles": 10, "iterations": 10, "runs": 2}
    one, two = (pp.gt(*sides.values(), seed=3, **settings) for _ in range(2))
    assert one.shape == two.shape and (one.net == two.net).all()
    assert one.figures["dirichlet"] <= fixed.figures["dirichlet"]
    blend = pp.gt(*sides.values(), patch="tb-coons", shape=(1, 1, 1, 1))
    assert blend.area > 0.0
    with pytest.raises(pp.BoundaryError, match="not both"):
        pp.gt(*sides.values(), shape=(1, 1, 1, 1), search=True)


def test_a_harmonic_net_of_two_sides_is_harmonic(sides: dict[str, np.ndarray]) -> None:
    patch = pp.harmonic(u0=sides["u0"], u1=sides["u1"], degree=3)
    assert patch.net.shape == (4, 3, 3) and patch.figures["laplacian_defect"] < 1e-20


def test_helicoids_are_minimal_and_bend_without_stretching() -> None:
    frames = pp.deformation(3, u_span=1.0, v_span=2.0)
    areas = [frame.area for frame in frames]
    assert len(frames) == 3 and max(areas) - min(areas) < 1e-9
    catenoid = pp.helicoid(0.0, 1.0, u_span=1.0, v_span=2.0)
    assert np.abs(catenoid.mean_curvature(0.5, np.linspace(0.0, 2.0, 9))).max() < 1e-9
    assert pp.trapezium_helicoid(3.9, [6.2, 12.5], [1.0, 0.5]).area > 0.0
    # 7 is beyond what one patch holds: it is cut into pieces that are evaluated as one.
    long = pp.helicoid(1.0, 0.0, u_span=1.0, v_span=9.0)
    assert long.kind == "pieces" and len(long.nets) > 1 and len(long.faces) == 1
    assert np.allclose(long.evaluate(0.5, 8.0), [np.sinh(0.5) * np.cos(8.0), np.sinh(0.5) * np.sin(8.0), 8.0])


def test_a_triangle_by_every_way() -> None:
    a, b, c = [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]
    sides = [[a, [1, 0, 1], b], [b, [1, 1, 1], c], [c, [0, 1, 1], a]]
    least = pp.triangle(*sides, degree=5)
    others = [
        pp.triangle(*sides, energy="dirichlet", degree=5),
        pp.triangle(*sides, energy="dirichlet", domain="equilateral", degree=5),
        pp.triangle(*sides, mask="coons", degree=5),
        pp.triangle(*sides, construction="discrete-coons"),
    ]
    assert all(least.area < other.area for other in others)
    assert least.domain is None and least.indices is not None and (least.indices.sum(axis=1) == 5).all()
    corner = int(np.flatnonzero((least.indices == [5, 0, 0]).all(axis=1))[0])
    assert least.net[corner].tolist() == a


def test_a_lower_bound_is_below_every_surface(sides: dict[str, np.ndarray]) -> None:
    loop = [sides["v0"], sides["u1"], sides["v1"], sides["u0"]]
    least = pp.least_area(*sides.values(), degree=10)
    for surface in (pp.fill([loop], degree=6, bound=True), pp.least_area(*sides.values(), degree=6, bound=True)):
        bound = surface.lower_bound
        assert bound is not None and bound.value < least.area + least.area_error < bound.value + 1e-3
        assert bound.holds_for == "every surface with this rim"
    assert least.lower_bound is None
    rings = [pp.Curve.circle([0, 0, z], [0, 0, 1], 1.0) for z in (-0.3, 0.3)]
    catenoid = pp.fill(rings, degree=4, bound=True)
    assert catenoid.lower_bound is None and any("no lower bound" in warning for warning in catenoid.warnings)


def test_layers_and_accuracy_are_those_of_the_command() -> None:
    corners = [[0, 0, 0], [2, 0, 0.5], [2, 1, 0], [1, 1, 0.6], [1, 2, 0], [0, 2, 0.5]]
    sides = [np.array([a, b], dtype=float) for a, b in zip(corners, [*corners[1:], corners[0]])]
    least = 3.18050100361
    without, layer = pp.fill([sides]), pp.fill([sides], layers=1)
    assert len(layer.faces) > len(without.faces)
    assert abs(layer.area - least) < 1e-10 < without.area - least < 1e-7
    # An area that is known in closed form: the degree rises until it is met.
    square = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]
    low, near = pp.fill(square, degree=2), pp.fill(square, degree=2, accuracy=1e-7)
    assert near.area - 1.279261571171 < 1.3e-7 < low.area - 1.279261571171
    for wrong in ({"layers": 2}, {"accuracy": 1.0}, {"layers": 1, "energy": "dirichlet"}):
        with pytest.raises(pp.BoundaryError):
            pp.fill([sides], **wrong)
