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
        ({"degree": 6.5}, "degree is 6.5; a whole number is expected"),
        ({"degree": "6"}, "degree is '6'; a finite number is expected"),
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
        (pp.Curves([], []), "no loop"),
        (3, "a list of loops, not 3"),
        ([[[0, 0, 0], [1, 0, 0]]], r"at least 3. A loop of sides is a list in the list"),
        (np.zeros((4, 2)), r"loops\[0\] has shape \(4, 2\)"),
        ([[[0, 0, 0], [1, 0, 0], [np.nan, 1, 0]]], r"loops\[0\]\[2\] is not finite"),
        ([[[[0, 0, 0], [1, 0, 0]], [[1, 0], [0, 0]]]], r"loops\[0\]\[1\] has shape"),
        ([[[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0.5, 1, 0]], [[0.5, 1, 0], [0, 0.2, 0]]]], "or `weld=.*` joins them"),
    ],
)
def test_wrong_loops_are_named(loops: object, sentence: str) -> None:
    with pytest.raises(pp.BoundaryError, match=sentence):
        pp.fill(loops)  # type: ignore[arg-type]


def test_parameters_may_be_rounded_and_numbers_give_numbers() -> None:
    strip = pp.helicoid(1.0, 0.0, u_span=0.3, v_span=1.0)
    (end,) = strip.evaluate([3 * 0.1], 0.0)
    assert 3 * 0.1 > 0.3 and (end == strip.evaluate(0.3, 0.0)).all()
    assert f"{strip.gauss_curvature(0.0, 0.0):.6f}" == "-1.000000" and isinstance(strip.mean_curvature(0, 0), float)


def test_wrong_parameters_are_named(sides: dict[str, np.ndarray]) -> None:
    patch = pp.dirichlet(*sides.values())
    with pytest.raises(ValueError, match=r"\(u, v\) = \(1.5, 0.0\) lies outside"):
        patch.evaluate([0.0, 1.5], 0.0)
    with pytest.raises(ValueError, match="lies outside"):
        patch.evaluate(np.nan, 0.0)
    with pytest.raises(ValueError, match=r"shapes \(2,\) and \(3,\) do not broadcast"):
        patch.evaluate([0.0, 1.0], [0.0, 0.5, 1.0])
    for wrong in (0, -1, 2.5, "a", 10**9):
        with pytest.raises(ValueError, match="subdivisions"):
            patch.mesh(wrong)  # type: ignore[arg-type]


def test_one_loop_may_stand_by_itself() -> None:
    pandas = pytest.importorskip("pandas")
    loop = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 0.0]])
    film = pp.fill([loop], degree=4)
    for same in (loop, loop.tolist(), pandas.DataFrame(loop, columns=list("xyz")), iter([loop])):
        assert pp.fill(same, degree=np.int64(4)) == film
    sides = np.stack([[a, b] for a, b in zip(loop, np.roll(loop, -1, axis=0))])
    assert pp.fill([sides], degree=4.0).area == film.area  # type: ignore[arg-type]
    # Vertices of faces have any names.
    ends = {(k, (k + 1) % 4): side for k, side in enumerate(sides)}
    assert pp.fill(faces=[range(4)], curves=ends, degree=4).area == pytest.approx(film.area, rel=1e-9)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda sides: pp.gt(*sides, shape=1.0), "shape is 1.0; a list of numbers"),
        (lambda sides: pp.gt(*sides, shape=(1, 1, 1, np.nan)), "shape is nan; a finite number"),
        (lambda sides: pp.mask(*sides, alpha="a"), "alpha is 'a'"),
        (lambda sides: pp.Curve("line", sides[0]), "'line' is no kind of curve"),
        (lambda sides: pp.Curve.circle(0, 1, 1), "the centre of the circle is 0; three"),
        (lambda sides: pp.Curve.circle([0, 0, 0], [0, 0, 1], "1"), "the radius of the circle is '1'"),
        (lambda sides: pp.Curve.spline(sides[0], [[0]], 2), r"knots of shape \(1, 1\)"),
        (lambda sides: pp.Curve.spline(sides[0], [0, 1], -2), "degree of a spline -2"),
        (lambda sides: pp.fill(sides[0], degree=4, weld=np.nan), "weld is nan"),
        (lambda sides: pp.fill(faces=["abc"], curves=[sides[0]]), "by the vertices at their ends"),
        (lambda sides: pp.dirichlet(*sides).save("x.obj", n=0), "subdivisions 0"),
        (lambda sides: pp.dirichlet(*sides).save("x.step", tolerance=-1), "tolerance -1"),
    ],
)
def test_wrong_numbers_are_named(sides: dict[str, np.ndarray], call: object, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        call(list(sides.values()))  # type: ignore[operator]
