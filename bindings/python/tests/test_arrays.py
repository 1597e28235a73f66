"""Arrays as users have them."""

from __future__ import annotations

import decimal

import numpy as np
import pytest

import plateau_patches as pp


def test_lists_orders_and_types_are_all_the_same(sides: dict[str, np.ndarray]) -> None:
    expected = pp.dirichlet(*sides.values()).net
    for change in (
        np.ndarray.tolist,
        np.asfortranarray,
        lambda side: side.astype(np.int32),
        lambda side: side.astype(np.float32),
        lambda side: side.astype(">f8"),
        lambda side: np.repeat(side, 2, axis=0)[::2],
        lambda side: side[::-1].copy()[::-1],
        tuple,
    ):
        assert (pp.dirichlet(*map(change, sides.values())).net == expected).all()
    for side in sides.values():
        side.flags.writeable = False
    assert (pp.dirichlet(*sides.values()).net == expected).all()


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda side: side[:, :2], r"u0 has shape \(3, 2\)"),
        (lambda side: side[None], r"u0 has shape \(1, 3, 3\)"),
        (lambda side: side.ravel(), r"u0 has shape \(9,\)"),
        (lambda side: side[:1], "u0 has 1 points; at least 2"),
        (lambda side: np.where(side == 2, np.nan, side), r"u0\[1\] is not finite: \[-1.0, 0.0, nan\]"),
        (lambda side: np.where(side == 2, np.inf, side), r"u0\[1\] is not finite"),
        (lambda side: side.astype(complex), "u0 has dtype complex128"),
        (lambda side: side.astype(str), "u0 has dtype <U"),
        (lambda side: side > 0, "u0 has dtype bool"),
        (lambda side: [[decimal.Decimal(1)] * 3] * 3, "u0 has dtype object"),
        (lambda side: [[0, 0, 0], [1, 0]], "u0 is no array"),
        (lambda side: np.ma.masked_equal(side, 2), "u0 has masked entries"),
        (lambda side: None, "u0 has dtype object"),
        (lambda side: side * 1e70, "coordinate"),
        (lambda side: side[[0, 1]], "points"),
        (lambda side: side + 1, "corner"),
    ],
)
def test_wrong_arrays_are_named(sides: dict[str, np.ndarray], change: object, sentence: str) -> None:
    sides["u0"] = change(sides["u0"])  # type: ignore[operator]
    with pytest.raises(ValueError, match=sentence):
        pp.least_area(*sides.values())


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"degree": 1}, "degree 1 is not offered; give one from 2"),
        ({"degree": 65}, "degree 65 is not offered"),
        ({"tolerance": 1.0}, "tolerance"),
    ],
)
def test_wrong_options_are_named(
    sides: dict[str, np.ndarray], arguments: dict[str, float], sentence: str
) -> None:
    with pytest.raises(ValueError, match=sentence):
        pp.least_area(*sides.values(), **arguments)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("loops", "sentence"),
    [
        ([], "no loop"),
        ([[[0, 0, 0], [1, 0, 0]]], "at least 3"),
        ([[[0, 0, 0], [1, 0, 0], [np.nan, 1, 0]]], r"loops\[0\]\[2\] is not finite"),
        ([[[[0, 0, 0], [1, 0, 0]], [[1, 0], [0, 0]]]], r"loops\[0\]\[1\] has shape"),
        ([[[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0.5, 1, 0]], [[0.5, 1, 0], [0, 0.5, 0]]]], "gap|apart|meet|open"),
    ],
)
def test_wrong_loops_are_named(loops: object, sentence: str) -> None:
    with pytest.raises(pp.BoundaryError, match=sentence):
        pp.fill(loops)  # type: ignore[arg-type]


def test_wrong_parameters_are_named(sides: dict[str, np.ndarray]) -> None:
    patch = pp.dirichlet(*sides.values())
    with pytest.raises(ValueError, match=r"\(u, v\) = \(1.5, 0.0\) lies outside"):
        patch.evaluate([0.0, 1.5], 0.0)
    with pytest.raises(ValueError, match="lies outside"):
        patch.evaluate(np.nan, 0.0)
    with pytest.raises(ValueError, match=r"shapes \(2,\) and \(3,\) do not broadcast"):
        patch.evaluate([0.0, 1.0], [0.0, 0.5, 1.0])
    with pytest.raises(ValueError, match="subdivisions"):
        patch.mesh(0)
