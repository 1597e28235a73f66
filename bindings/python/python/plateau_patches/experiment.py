"""Experiments: files of ``plateau run``, and the same as text or dict."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from html import escape
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np

from . import _engine
from .arrays import Floats
from .errors import FormatError, MethodError
from .report import Report
from .surface import Surface
from .toml import dumps

Told = Callable[[str, int, "int | None"], object]


class Results(Mapping[str, Surface]):
    """What came of an experiment: its surfaces by the names of its methods, in their order.

    A method that failed keeps its place; to take its surface raises its error.
    """

    def __init__(self, record: str, experiment: str, run: _engine.Run | None = None, unit: str | None = None) -> None:
        self._text = record
        self._record: dict[str, Any] = json.loads(record)
        self._run = run
        self.experiment = experiment
        """The text of the experiment; empty where only its result was read."""
        self._places = {method["name"]: k for k, method in enumerate(self._record["methods"])}
        self._surfaces: dict[str, Surface] = {}
        self._unit = run.unit if run else unit

    def __getitem__(self, name: str) -> Surface:
        if name not in self._places:
            raise KeyError(f"there is no method {name!r}; there are: {', '.join(map(repr, self))}")
        place = self._places[name]
        if name not in self._surfaces:
            entry = self._record["methods"][place]
            if "error" in entry:
                raise MethodError(f"{name}: {entry['error']}")
            handle = self._run.surface(place) if self._run else _engine.Surface.restore(json.dumps(entry))
            self._surfaces[name] = Surface(handle, self.title, self._record.get("warnings", []), self.experiment, self._unit)
        return self._surfaces[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    @property
    def title(self) -> str:
        """The title of the experiment."""
        return str(self._record["title"])

    @property
    def seed(self) -> int:
        """The seed of its searches."""
        return int(self._record["seed"])

    @property
    def record(self) -> dict[str, Any]:
        """What ``result.json`` holds."""
        record: dict[str, Any] = json.loads(self._text)
        return record

    @property
    def warnings(self) -> list[str]:
        """What a reader must know about the whole, one sentence each; those of a method are its surface's."""
        return list(self._record.get("warnings", []))

    @property
    def failures(self) -> dict[str, str]:
        """The methods that failed, with their errors."""
        return {m["name"]: m["error"] for m in self._record["methods"] if "error" in m}

    @property
    def missed(self) -> list[dict[str, Any]]:
        """The numbers the experiment expects that were not met: ``method``, ``quantity``, ``expected``, ``found``."""
        return list(self._record.get("missed", []))

    @property
    def curve(self) -> dict[str, Floats] | None:
        """Of an experiment with a curve: parameters ``t`` (k,), ``point``, ``d1``, ``d2`` (k, 2 or 3), ``basis`` and its
        derivatives (k, n + 1), ``curvature`` (k,)."""
        curve = self._record.get("curve")
        if curve is None:
            return None
        return {key: np.asarray(value, dtype=np.float64) for key, value in curve.items() if isinstance(value, list)}

    def table(self, width: int = 160) -> str:
        """The table that the command prints, at most ``width`` columns wide."""
        return self._ran().table(width)

    def report(self) -> Report:
        """The page that the command writes."""
        if self._run is not None:
            return Report(self._run.page())
        handles = [self[name]._handle for name in self if name not in self.failures]
        return Report(_engine.page(self.title, handles, self.warnings, self.experiment)[0])

    def save(self, folder: str | PathLike[str]) -> Path:
        """Writes what the command writes: a folder with ``result.json``, the page and the files the experiment asks for.

        Returns:
            The folder, in ``folder``, named by the experiment.
        """
        written, _ = self._ran().deliver(Path(fspath(folder)))
        return Path(written)

    def _ran(self) -> _engine.Run:
        if self._run is None:
            raise MethodError("only the record is there, of a result that was read or unpickled: run its experiment again")
        return self._run

    def __repr__(self) -> str:
        return f"<Results {self.title!r}: {', '.join(self) or 'a curve'}>"

    def _repr_html_(self) -> str:
        done = [self[name]._handle for name in self if name not in self.failures]
        pictures = {name: svg for name, _, svg in _engine.page(self.title, done, [], "")[1]}
        head = "<tr><th>method</th><th>area</th><th>error</th></tr>"
        rows = "".join(
            f"<tr><td>{escape(name)}</td><td>{self[name].area:.10g}</td><td>{self[name].area_error:.1e}</td></tr>"
            for name in self
            if name not in self.failures
        )
        return f"<div>{pictures.get('surfaces', '')}</div><table>{head}{rows}</table>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Results, (self._text, self.experiment, None, self._unit)


def run(
    source: str | PathLike[str] | Mapping[str, Any],
    *,
    seed: int | None = None,
    progress: Told | None = None,
) -> Results:
    """Runs an experiment.

    Args:
        source: the path of a file, its text (what has more than one line), or a dict of the same tables and keys, with arrays
            for lists, and underscores for hyphens if you like.
        seed: instead of that of the experiment.
        progress: called with (what is done, steps, of how many) a few times a second.

    Raises:
        ExperimentError: the experiment is refused; its ``faults`` point at lines and columns.
        OSError: the file cannot be read.

    >>> import plateau_patches as pp
    >>> side = [[0, 0, 0], [1, 0, 1], [2, 0, 0]]
    >>> result = pp.run({
    ...     "boundary": {
    ...         "u0": [[0, 0, 0], [0, 1, 1], [0, 2, 0]], "u1": [[2, 0, 0], [2, 1, 1], [2, 2, 0]],
    ...         "v0": side, "v1": [[0, 2, 0], [1, 2, 1], [2, 2, 0]],
    ...     },
    ...     "method": [{"name": "Coons", "energy": "coons"}, {"name": "Least area", "energy": "area", "raise": 4}],
    ... })
    >>> list(result), result["Least area"].area < result["Coons"].area
    (['Coons', 'Least area'], True)
    """
    if isinstance(source, Mapping):
        text, name = dumps({"title": "experiment", **source}), "experiment.toml"
    elif isinstance(source, str) and "\n" in source:
        text, name = source, "experiment.toml"
    else:
        path = Path(fspath(source))
        text, name = path.read_text(encoding="utf-8"), str(path)
    ran = _engine.run(text, name, seed, progress)
    return Results(ran.record(), text, ran)


def load(path: str | PathLike[str]) -> Results:
    """The surfaces of a ``result.json``, bit for bit.

    Raises:
        FormatError: the file is no result.
        OSError: it cannot be read.
    """
    text = Path(fspath(path)).read_text(encoding="utf-8")
    try:
        return Results(text, "")
    except (ValueError, KeyError, TypeError) as error:
        raise FormatError(f"{path}: this should be a result.json of `plateau run`: {error!r}") from None
