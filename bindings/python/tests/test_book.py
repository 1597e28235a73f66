"""What the book shows runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from conftest import ROOT


def blocks(page: str) -> list[str]:
    text = (ROOT / page).read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```", text, flags=re.S | re.M)


def test_the_page_of_python(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fixtures: Path) -> None:
    monkeypatch.chdir(tmp_path)
    corners = ["0 0 0", "1 0 0", "1 1 1", "0 1 0"]
    lines = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        pairs = [*zip((10, 20, 30), a.split()), *zip((11, 21, 31), b.split())]
        lines.append("0\nLINE\n8\n0\n" + "".join(f"{code}\n{x}\n" for code, x in pairs))
    Path("rim.dxf").write_text("0\nSECTION\n2\nENTITIES\n" + "".join(lines) + "0\nENDSEC\n0\nEOF\n")
    Path("experiment.toml").write_text((fixtures / "gallery" / "schwarz-d.toml").read_text())
    names: dict[str, object] = {}
    shown = blocks("docs/python.md")
    assert len(shown) >= 4
    for block in shown:
        exec(compile(block, "docs/python.md", "exec"), names)  # noqa: S102
    assert abs(names["patch"].area - 7.3835056) < 1e-7  # type: ignore[attr-defined]
    assert Path("saddle.step").exists() and Path("out").is_dir()


def test_the_lines_of_the_readmes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, sides: dict[str, object]) -> None:
    import numpy as np

    monkeypatch.chdir(tmp_path)
    experiment = "title = 'x'\n[helicoid]\na = 1.0\nb = 0.0\nu-span = 1.0\nv-span = 1.0\n"
    Path("experiment.toml").write_text(experiment)
    t = np.linspace(0.0, 6.0, 50)
    loop = np.stack([np.cos(t), np.sin(t), 0.1 * t * (6.0 - t)], axis=1)
    for page in ("README.md", "bindings/python/README.md"):
        (block,) = blocks(page)
        exec(compile(block, page, "exec"), {**sides, "loop": loop, "u": 0.5, "v": [0.0, 1.0]})  # noqa: S102
    assert Path("patch.step").exists() and Path("film.step").exists()
