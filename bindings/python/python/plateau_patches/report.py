"""Pages of results."""

from __future__ import annotations

import html
from os import PathLike
from pathlib import Path


class Report(str):
    """A page of HTML that needs nothing but itself. Shown as such in a notebook."""

    __slots__ = ()

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the page."""
        Path(path).write_text(self, encoding="utf-8")

    def __repr__(self) -> str:
        return f"<Report: {len(self)} characters of HTML; save(path) writes them>"

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self)}" width="100%" height="640" style="border:0"></iframe>'
