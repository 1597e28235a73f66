"""Experiments in Python's words as TOML."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np


def dumps(experiment: Mapping[str, Any]) -> str:
    """The text of an experiment given as a dict: lists of dicts are arrays of tables, arrays are lists, and names may have
    underscores for hyphens.

    >>> print(dumps({"title": "Two", "method": [{"energy": "area", "metric_steps": 2}]}), end="")
    title = "Two"
    <BLANKLINE>
    [[method]]
    energy = "area"
    metric-steps = 2
    """
    plain, tables = [], []
    for key, value in experiment.items():
        if isinstance(value, Mapping):
            tables.append(_table(f"[{_key(key)}]", value))
        elif _is_tables(value):
            tables.extend(_table(f"[[{_key(key)}]]", table) for table in value)
        else:
            plain.append(f"{_key(key)} = {_value(value, key)}\n")
    return "\n".join(["".join(plain), *tables])


def _table(head: str, table: Mapping[str, Any]) -> str:
    entries = (f"{_key(key)} = {_value(value, key)}\n" for key, value in table.items())
    return f"{head}\n" + "".join(entries)


def _is_tables(value: object) -> bool:
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(table, Mapping) for table in value)


def _key(key: object) -> str:
    if not isinstance(key, str):
        raise TypeError(f"the names of an experiment are texts, not {type(key).__name__}: {key!r}")
    name = key.replace("_", "-")
    return name if name and all(c.isascii() and (c.isalnum() or c == "-") for c in name) else _text(name)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: object, key: object) -> str:
    if hasattr(value, "__array__"):
        # Of NumPy, pandas and their relatives.
        value = np.asarray(value).tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(name)} = {_value(inner, name)}" for name, inner in value.items()) + " }"
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(_value(inner, key) for inner in value) + "]"
    raise TypeError(f"{key}: an experiment holds no {type(value).__name__}")
