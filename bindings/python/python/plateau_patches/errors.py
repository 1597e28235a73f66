"""What goes wrong, in the sentences of the engine."""

from __future__ import annotations

from typing import NamedTuple


class PlateauError(Exception):
    """Anything this package refuses or fails at."""


class BoundaryError(PlateauError, ValueError):
    """What was given is no boundary: arrays that hold no points, curves that do not meet, parameters outside of the domain."""


class Fault(NamedTuple):
    """One fault of an experiment."""

    line: int | None
    """The line of the text, from 1; None if the whole is meant."""
    column: int | None
    """The column, from 1, in characters."""
    message: str
    """What is wrong, in one sentence."""
    help: str
    """What to do; empty where there is nothing to be said."""


class ExperimentError(PlateauError, ValueError):
    """An experiment that was refused. As text it is the report of the command ``plateau check``."""

    def __init__(self, report: str, faults: list[tuple[int | None, int | None, str, str]]) -> None:
        super().__init__(report, faults)
        self.report = report
        self.faults = [Fault(*fault) for fault in faults]
        """Every fault, in the order of the text."""

    def __str__(self) -> str:
        return self.report


class MethodError(PlateauError, RuntimeError):
    """A method found no surface."""


class FormatError(PlateauError, ValueError):
    """A format that is not known, or cannot hold the surface."""
