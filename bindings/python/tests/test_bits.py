"""The same bits as the command."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import plateau_patches as pp

SMALL = {"files", "manifest", "unwritten"}


def without_files(record: dict[str, object]) -> dict[str, object]:
    methods = [{k: v for k, v in method.items() if k != "files"} for method in record["methods"]]  # type: ignore[attr-defined]
    return {**{key: value for key, value in record.items() if key not in SMALL}, "methods": methods}


@pytest.mark.parametrize("name", ["gt-5.1", "tri-enneper-n3", "gallery/schwarz-d", "gallery/tetrahedron-film", "helicoid", "coons-triangle"])
def test_an_experiment(name: str, command: Callable[..., str], fixtures: Path, tmp_path: Path) -> None:
    path = fixtures / f"{name}.toml"
    if not path.exists():
        pytest.fail(f"{path} is not there")
    command("run", path, "--out", tmp_path)
    record = json.loads((tmp_path / path.stem / "result.json").read_text())
    results = pp.run(path)
    assert without_files(results.record) == without_files(record)
    for entry in record["methods"]:
        surface = results[entry["name"]]
        net, faces = entry.get("net"), entry.get("faces", [])
        if net is not None and isinstance(net[0], list):
            assert (surface.net == np.array(net)).all()
        elif net is not None:
            assert surface.indices is not None and surface.indices.tolist() == [point["index"] for point in net]
            assert (surface.net == np.array([point["point"] for point in net])).all()
        assert all((ours == np.array(face["net"])).all() for ours, face in zip(surface.nets, faces))


def test_a_filled_loop(command: Callable[..., str], wave: np.ndarray, tmp_path: Path) -> None:
    table = tmp_path / "wave.csv"
    np.savetxt(table, wave, fmt="%.17g", delimiter=",")
    told = command("fill", table, "--degree", 6, "-o", tmp_path / "command.step", "-o", tmp_path / "command.obj")
    film = pp.fill([wave], degree=6, name="wave")
    film.save(tmp_path / "ours.step")
    film.save(tmp_path / "ours.obj")
    for extension in ("step", "obj"):
        ours = (tmp_path / f"ours.{extension}").read_text().splitlines()
        theirs = (tmp_path / f"command.{extension}").read_text().splitlines()
        same = [a == b for a, b in zip(ours, theirs)]
        # Names and times may differ in the head, numbers may not.
        assert len(ours) == len(theirs) and sum(not s for s in same) <= 3, extension
    assert f"{film.area:.9f}"[:11] in told


def test_a_function_is_an_experiment_of_the_command(
    command: Callable[..., str], sides: dict[str, np.ndarray], tmp_path: Path
) -> None:
    patch = pp.least_area(*sides.values(), degree=7)
    (tmp_path / "patch.toml").write_text(patch.experiment)
    command("run", tmp_path / "patch.toml", "--out", tmp_path)
    (entry,) = json.loads((tmp_path / "patch" / "result.json").read_text())["methods"]
    assert (np.array(entry["net"]) == patch.net).all() and entry["area"] == patch.area
