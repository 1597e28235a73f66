"""Pickles and copies."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import plateau_patches as pp


def test_a_surface_survives_bit_for_bit(sides: dict[str, np.ndarray], wave: np.ndarray) -> None:
    triangle = pp.triangle([[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0, 1, 1]], [[0, 1, 1], [0, 0, 0]], degree=4)
    for surface in (
        pp.least_area(*sides.values(), degree=5),
        pp.gt(*sides.values(), shape=(1, 2, 1, 2)),
        pp.gt(*sides.values(), shape=(1, 2, 1, 2), patch="tb-coons"),
        triangle,
        pp.fill([wave], degree=4),
        pp.helicoid(1.0, 0.5, u_span=1.0, v_span=9.0),
        pp.trapezium_helicoid(3.9, [6.2, 12.5], [1.0, 0.5]),
    ):
        again = pickle.loads(pickle.dumps(surface))
        assert (again.figures, again.warnings, again.name) == (surface.figures, surface.warnings, surface.name)
        assert again == surface and hash(again) == hash(surface)
        assert again.experiment == surface.experiment and again.kink == surface.kink
        assert all((a == b).all() for a, b in zip(again.nets, surface.nets))
        assert (again.mesh(7).vertices == surface.mesh(7).vertices).all()
        assert (again.mesh(7).faces == surface.mesh(7).faces).all()
        at = (0.2, 0.3)
        assert (again.faces[0].evaluate(*at) == surface.faces[0].evaluate(*at)).all()
        assert again.picture == surface.picture
        assert (copy.deepcopy(surface).nets[0] == copy.copy(surface).nets[0]).all()


def test_results_errors_and_curves_survive(fixtures: Path, tmp_path: Path) -> None:
    results = pp.run(fixtures / "tri-enneper-n3.toml")
    again = pickle.loads(pickle.dumps(results))
    assert list(again) == list(results) and again.record == results.record
    assert all((again[name].nets[0] == results[name].nets[0]).all() for name in results)
    assert "<svg" in again.report() and again.title == results.title
    with pytest.raises(pp.MethodError, match="run its experiment again"):
        again.table()
    with pytest.raises(pp.ExperimentError) as caught:
        pp.run("title = 1\n")
    error = pickle.loads(pickle.dumps(caught.value))
    assert str(error) == str(caught.value) and error.faults == caught.value.faults
    curve = pp.Curve.bezier([[0, 0, 0], [1, 1, 0], [2, 0, 0]])
    assert pickle.loads(pickle.dumps(curve)) == curve != pp.Curve.bezier([[0, 0, 0], [1, 1, 0], [2, 0, 1]])
