"""What users pass as points and parameters, checked once."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import BoundaryError

Floats = npt.NDArray[np.float64]


def numbers(value: Any, what: str) -> Floats:
    """``value`` as float64 in C order; itself, if it is that already."""
    if np.ma.is_masked(value):
        raise BoundaryError(f"{what} has masked entries: fill or leave them out")
    try:
        array: npt.NDArray[Any] = np.asarray(value)
    except ValueError as error:
        raise BoundaryError(f"{what} is no array: {error}") from None
    if array.dtype.kind not in "fiu":
        raise BoundaryError(f"{what} has dtype {array.dtype}; real numbers are expected")
    return np.ascontiguousarray(array, dtype=np.float64)


def number(value: Any, what: str) -> float:
    """``value`` as a finite real number."""
    try:
        found = float(value)
    except (TypeError, ValueError):
        found = float("nan")
    if isinstance(value, (str, bytes)) or not np.isfinite(found):
        raise BoundaryError(f"{what} is {value!r}; a finite number is expected")
    return found


def whole(value: Any, what: str, least: int, most: int) -> int:
    """``value`` as a whole number within its range; 8.0 is 8."""
    found = number(value, what)
    if not found.is_integer():
        raise BoundaryError(f"{what} is {value!r}; a whole number is expected")
    if not least <= found <= most:
        raise BoundaryError(f"{what} {value} is not offered; give one from {least} to {most}")
    return int(found)


def points(value: Any, what: str, least: int = 2) -> Floats:
    """``value`` as points of space, shape (n, 3), all finite, at least ``least`` of them."""
    array = numbers(value, what)
    if array.ndim != 2 or array.shape[1] != 3:
        raise BoundaryError(f"{what} has shape {array.shape}; points of space are expected, shape (n, 3)")
    if len(array) < least:
        raise BoundaryError(f"{what} has {len(array)} points; at least {least} are expected")
    finite = np.isfinite(array).all(axis=1)
    if not finite.all():
        first = int(np.argmin(finite))
        raise BoundaryError(f"{what}[{first}] is not finite: {array[first].tolist()}")
    return array


def parameters(
    u: npt.ArrayLike, v: npt.ArrayLike, domain: tuple[tuple[float, float], tuple[float, float]] | None
) -> tuple[Floats, tuple[int, ...]]:
    """u and v broadcast to one shape, as pairs (k, 2) inside the domain (None: u, v ≥ 0, u + v ≤ 1), and that shape."""
    us, vs = numbers(u, "u"), numbers(v, "v")
    # An array without dimensions comes out of `ascontiguousarray` with one.
    us, vs = us.reshape(np.shape(u)), vs.reshape(np.shape(v))
    try:
        us, vs = np.broadcast_arrays(us, vs)
    except ValueError:
        raise BoundaryError(f"u and v of shapes {np.shape(u)} and {np.shape(v)} do not broadcast") from None
    pairs = np.stack([us.ravel(), vs.ravel()], axis=1)
    low, high = np.array(domain or ((0.0, 1.0), (0.0, 1.0))).T
    if domain is None:
        inside = (pairs >= 0.0).all(axis=1) & (pairs.sum(axis=1) <= 1.0 + 1e-12)
        where = "the triangle u, v ≥ 0, u + v ≤ 1"
    else:
        (u0, u1), (v0, v1) = domain
        # 3 · 0.1 is a little more than 0.3.
        inside = (np.abs(pairs - 0.5 * (low + high)) <= (0.5 + 1e-12) * (high - low)).all(axis=1)
        where = f"[{u0:g}, {u1:g}] × [{v0:g}, {v1:g}]"
    if not inside.all():
        first = pairs[int(np.argmin(inside))].tolist()
        raise BoundaryError(f"(u, v) = ({first[0]}, {first[1]}) lies outside of the domain {where}")
    np.clip(pairs, low, high, out=pairs)
    return pairs, us.shape
