"""The examples run, as the notebooks they are."""

from __future__ import annotations

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
def test_an_example(example: Path, tmp_path: Path) -> None:
    jupytext = pytest.importorskip("jupytext")
    nbclient = pytest.importorskip("nbclient")
    for library in ["ipykernel", *NEEDS.get(example.stem, [])]:
        pytest.importorskip(library)
    notebook = jupytext.read(example)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert len(cells) >= 3 and len(notebook.cells) > len(cells)
    # Files are written where it runs.
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [output for cell in cells for output in cell.outputs]
    assert outputs and not any(output.output_type == "error" for output in outputs)
    if example.stem == "five_minutes":
        # A surface by itself in a cell is its picture and its figures.
        assert any("<svg" in output.get("data", {}).get("text/html", "") for output in outputs)


def test_there_are_examples() -> None:
    assert {path.stem for path in EXAMPLES} >= {"five_minutes", *NEEDS}
