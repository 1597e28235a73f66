"""What the tests share."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def sides() -> dict[str, np.ndarray]:
    """The frame of the saddle z = x² − y² over [−1, 1]²."""
    rows = {
        "u0": [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]],
        "u1": [[1, -1, 0], [1, 0, 2], [1, 1, 0]],
        "v0": [[-1, -1, 0], [0, -1, -2], [1, -1, 0]],
        "v1": [[-1, 1, 0], [0, 1, -2], [1, 1, 0]],
    }
    return {name: np.array(side, dtype=float) for name, side in rows.items()}


@pytest.fixture
def wave() -> np.ndarray:
    """A smooth closed loop, as 60 points."""
    t = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)
    return np.stack([np.cos(t), np.sin(t), 0.3 * np.cos(2.0 * t)], axis=1)


@pytest.fixture(scope="session")
def fixtures() -> Path:
    """The experiments of the repository."""
    return ROOT / "fixtures"


@pytest.fixture(scope="session")
def command() -> Callable[..., str]:
    """The command `plateau`, built beside the package; PLATEAU names another."""
    program = os.environ.get("PLATEAU", str(ROOT / "target" / "release" / "plateau"))
    if not Path(program).exists():
        pytest.fail(f"{program} is not there: cargo build --release -p plateau-cli, or name it by PLATEAU")

    def call(*arguments: object) -> str:
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return call
