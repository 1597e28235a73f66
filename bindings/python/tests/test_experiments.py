"""Experiments: files, texts, dicts."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import plateau_patches as pp

POLYGON = """
title = "A skew square"
[boundary]
polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]
[[method]]
name = "Least area"
energy = "area"
degree = 6
"""


def test_a_file_its_text_and_a_dict_are_one_experiment(fixtures: Path, tmp_path: Path) -> None:
    path = tmp_path / "skew.toml"
    path.write_text(POLYGON)
    as_dict = {
        "title": "A skew square",
        "boundary": {"polygon": np.array([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]])},
        "method": [{"name": "Least area", "energy": "area", "degree": np.int64(6)}],
    }
    nets = [pp.run(source)["Least area"].nets for source in (path, str(path), POLYGON, as_dict)]
    assert all((a == b).all() for other in nets for a, b in zip(nets[0], other))


def test_a_refusal_points(tmp_path: Path) -> None:
    with pytest.raises(pp.ExperimentError) as caught:
        pp.run(POLYGON.replace("degree", "degre"))
    (fault,) = caught.value.faults
    assert (fault.line, fault.column) == (8, 1) and "degre" in fault.message and "degree" in fault.help
    assert "experiment.toml:8:1" in str(caught.value) and isinstance(caught.value, ValueError)
    with pytest.raises(FileNotFoundError):
        pp.run(tmp_path / "none.toml")
    with pytest.raises(TypeError, match="an experiment holds no set"):
        pp.run({"title": {1}})


def test_experiments_and_functions_end_at_the_same_degree() -> None:
    for degree in (0, 25):
        with pytest.raises(pp.ExperimentError, match="between 1 and 24"):
            pp.run(POLYGON.replace("degree = 6", f"degree = {degree}"))
        with pytest.raises(pp.BoundaryError, match="from 1 to 24"):
            pp.fill([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]], degree=degree)


def test_a_method_that_fails_keeps_its_place() -> None:
    # All four sides are one straight line: there is no area.
    line = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
    point = [[0, 0, 0]] * 3
    results = pp.run(
        {
            "boundary": {"u0": line, "u1": line, "v0": point, "v1": [[2, 0, 0]] * 3},
            "method": [{"name": "Flat", "energy": "dirichlet"}, {"name": "Area", "energy": "area"}],
        }
    )
    assert list(results) == ["Flat", "Area"] and list(results.failures) == ["Area"]
    assert results["Flat"].warnings and "Area" not in [s.name for s in [results["Flat"]]]
    with pytest.raises(pp.MethodError, match="^Area: "):
        _ = results["Area"]
    with pytest.raises(KeyError, match="no method 'None'; there are: 'Flat', 'Area'"):
        _ = results["None"]
    with pytest.raises(pp.MethodError):
        pp.least_area(line, line, point, [[2, 0, 0]] * 3)
    assert "<svg" in results.report()


def test_a_curve_is_sampled() -> None:
    results = pp.run(
        {"curve": {"basis": "bernstein", "points": [[0, 0], [1, 2], [3, 2], [4, 0]], "samples": 5}}
    )
    assert results.curve is not None and len(results) == 0
    assert results.curve["point"].shape == (5, 2) and results.curve["curvature"].shape == (5,)
    assert results.curve["point"][2].tolist() == [2.0, 1.5]


def test_a_folder_is_what_the_command_writes(tmp_path: Path) -> None:
    results = pp.run(POLYGON + '[output]\nformats = ["step"]\n')
    folder = results.save(tmp_path)
    record = json.loads((folder / "result.json").read_text())
    assert record["methods"][0]["name"] == "Least area" and (folder / "report.html").exists()
    read = pp.load(folder / "result.json")
    assert (read["Least area"].nets[0] == results["Least area"].nets[0]).all()
    assert read["Least area"].area == results["Least area"].area
    with pytest.raises(pp.FormatError, match="result.json"):
        pp.load(Path(__file__))


def test_a_seed_may_be_given_and_expected_numbers_are_compared(fixtures: Path) -> None:
    text = (fixtures / "gt-5.1.toml").read_text()
    one, two = pp.run(text, seed=5), pp.run(text, seed=5)
    assert one.seed == 5 and one.record == two.record and one.table() == two.table()
    missed = pp.run(POLYGON.replace("degree = 6", 'degree = 6\nexpect = { area = 2.0 }')).missed
    assert [entry["quantity"] for entry in missed] == ["area"]
