"""The examples run."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).resolve().parents[1] / "examples").glob("*.py"))
NEEDS = {
    "canopy": ["rhino3dm"],
    "heights": ["matplotlib", "pandas"],
    "scikit_fem": ["skfem"],
    "table_1": ["pandas"],
}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_an_example(
    example: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for library in NEEDS.get(example.stem, []):
        pytest.importorskip(library)
    # Files are written where it runs; plots need no screen.
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    runpy.run_path(str(example))
    assert capsys.readouterr().out


def test_there_are_examples() -> None:
    assert {path.stem for path in EXAMPLES} >= {"five_minutes", *NEEDS}
