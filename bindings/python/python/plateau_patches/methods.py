"""Ways to fill three or four sides with one patch, and surfaces in closed form.

Every function here writes an experiment of one method and runs it: names, defaults and bits are those of the command, and
:attr:`Surface.experiment` is the text.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy.typing as npt

from .arrays import number, points, whole
from .errors import BoundaryError, MethodError
from .experiment import run
from .surface import Surface

Told = Callable[[str, int, "int | None"], object]

_Sides = Mapping[str, "npt.ArrayLike | None"]


def least_area(
    u0: npt.ArrayLike,
    u1: npt.ArrayLike,
    v0: npt.ArrayLike,
    v1: npt.ArrayLike,
    *,
    degree: int | None = None,
    tolerance: float | None = None,
    bound: bool = False,
    progress: Told | None = None,
) -> Surface:
    """The tensor Bézier patch of least area over four sides.

    Args:
        u0, u1: control points of the sides u = 0 and u = 1, shape (n + 1, 3), in the sense of v.
        v0, v1: control points of the sides v = 0 and v = 1, shape (m + 1, 3), in the sense of u. The corners stand in two sides.
        degree: of the patch, 32 at most: the larger of its two degrees. By default that of the sides; a higher one has less
            area, nearer to the least of all surfaces.
        tolerance: the relative decrease of the area that counts as none while points move along the surface.
        bound: whether a lower bound of the least area is proved, too: :attr:`Surface.lower_bound`.
        progress: called with (what is done, steps, of how many) a few times a second.

    Raises:
        BoundaryError: the arrays hold no points; :class:`ExperimentError`: the sides make no boundary.
        MethodError: no surface was found.

    >>> import plateau_patches as pp
    >>> u0, u1 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]], [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
    >>> v0, v1 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]], [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]
    >>> patch = pp.least_area(u0, u1, v0, v1, degree=8)
    >>> round(patch.area, 6), patch.net.shape
    (7.383506, (9, 9, 3))
    """
    method = {"name": "Least area", "energy": "area", "tolerance": tolerance, "bound": bound or None}
    return _solved(_sides(u0, u1, v0, v1), method, degree, progress=progress)


def dirichlet(
    u0: npt.ArrayLike,
    u1: npt.ArrayLike,
    v0: npt.ArrayLike,
    v1: npt.ArrayLike,
    *,
    degree: int | None = None,
    metric_steps: int | None = None,
) -> Surface:
    """The tensor Bézier patch of least Dirichlet energy ½∫(E + G) over four sides, as in :func:`least_area`, of degree 64 at
    most.

    Args:
        metric_steps: steps of the metric correction afterwards, each the extremal in the metric of the surface before.
    """
    method = {"name": "Dirichlet", "energy": "dirichlet", "metric-steps": metric_steps}
    return _solved(_sides(u0, u1, v0, v1), method, degree)


def extremal(
    u0: npt.ArrayLike,
    u1: npt.ArrayLike,
    v0: npt.ArrayLike,
    v1: npt.ArrayLike,
    *,
    energy: str,
    degree: int | None = None,
) -> Surface:
    """The tensor Bézier patch that minimises ``energy`` over four sides, as in :func:`least_area`: ``"dirichlet"``,
    ``"laplacian"`` ∫‖x_uu + x_vv‖², ``"bending"`` ∫‖x_uu‖² + 2‖x_uv‖² + ‖x_vv‖², ``"coons"`` ∫‖x_uv‖², ``"area"``."""
    return _solved(_sides(u0, u1, v0, v1), {"name": str(energy).capitalize(), "energy": str(energy)}, degree)


def mask(
    u0: npt.ArrayLike,
    u1: npt.ArrayLike,
    v0: npt.ArrayLike,
    v1: npt.ArrayLike,
    *,
    alpha: float = -0.25,
    degree: int | None = None,
) -> Surface:
    """The tensor Bézier patch whose free control points are α times the four at their corners and β times the four beside
    them, 4α + 4β = 1; −1/4 is the discrete Coons patch's."""
    return _solved(_sides(u0, u1, v0, v1), {"name": "Mask", "mask": number(alpha, "alpha")}, degree)


def discrete_coons(
    u0: npt.ArrayLike, u1: npt.ArrayLike, v0: npt.ArrayLike, v1: npt.ArrayLike, *, degree: int | None = None
) -> Surface:
    """The discrete Coons patch over four sides, as in :func:`least_area`."""
    return _solved(_sides(u0, u1, v0, v1), {"name": "Discrete Coons", "construction": "discrete-coons"}, degree)


def harmonic(
    *,
    u0: npt.ArrayLike | None = None,
    u1: npt.ArrayLike | None = None,
    v0: npt.ArrayLike | None = None,
    v1: npt.ArrayLike | None = None,
    degree: int | None = None,
) -> Surface:
    """The harmonic Bézier patch over two opposite sides, u0 and u1 or v0 and v1, with ``degree`` in the other direction (by
    default that of the sides); or over all four, where they admit one."""
    boundary = {name: side for name, side in zip(("u0", "u1", "v0", "v1"), (u0, u1, v0, v1)) if side is not None}
    sides = _sides_of(boundary)
    if len(sides) == 2:
        across = "u-degree" if "u0" in sides else "v-degree"
        of_sides = len(next(iter(sides.values()))) - 1
        sides[across] = of_sides if degree is None else whole(degree, "degree", 1, 64)
    elif degree is not None:
        raise BoundaryError("four sides have their degrees: leave out degree")
    return _solved(sides, {"name": "Harmonic", "construction": "harmonic"}, None)


def gt(
    u0: npt.ArrayLike,
    u1: npt.ArrayLike,
    v0: npt.ArrayLike,
    v1: npt.ArrayLike,
    *,
    shape: Sequence[float] | None = None,
    search: bool | str | None = None,
    energy: str = "dirichlet",
    patch: str = "tensor",
    search_energy: str | None = None,
    degree: int | None = None,
    seed: int = 0,
    variant: str | None = None,
    particles: int | None = None,
    iterations: int | None = None,
    runs: int | None = None,
    inertia: float | None = None,
    social: float | None = None,
    cognitive: float | None = None,
    box: tuple[float, float] | None = None,
    neighbours: int | None = None,
    progress: Told | None = None,
) -> Surface:
    """The patch of generalized trigonometric functions with shape parameters (α1, α2; β1, β2) that minimises ``energy``.

    Args:
        u0, u1, v0, v1: control points as in :func:`least_area`, of degree 2 or more.
        shape: the four parameters, each in [0, 4]. Without them they are searched.
        search: ``"pso"`` (a swarm), ``"polish"`` (descents), ``"pso-polish"`` (both) or True: both, but descents alone where
            ``energy`` is ``"area"``.
        energy: what the interior minimises, as in :func:`extremal`.
        patch: ``"tensor"``, or ``"tb-coons"``, the Bernstein–GT Coons blend.
        search_energy: what the search minimises, if not ``energy``.
        seed: of the search; the same seed gives the same bits, on any number of threads.
        variant: of the swarm, ``"global"`` or ``"local"``, where each particle is informed by ``neighbours`` on each side.
        particles, iterations, runs: how many, each run from a start of its own.
        inertia, social, cognitive: what the velocity keeps of itself, and the pulls of the best of all and of its own.
        box: the least and the largest value of every parameter that is searched.
        progress: called with (what is done, steps, of how many) a few times a second.

    >>> import plateau_patches as pp
    >>> u0, u1 = [[0, 0, 0], [2, 0, 2], [4, 0, -2], [6, 0, 0]], [[0, 6, 0], [2, 6, 2], [4, 6, -2], [6, 6, 0]]
    >>> v0, v1 = [[0, 0, 0], [0, 2, 2], [0, 4, -2], [0, 6, 0]], [[6, 0, 0], [6, 2, 2], [6, 4, -2], [6, 6, 0]]
    >>> patch = pp.gt(u0, u1, v0, v1, shape=(1, 1, 1, 1))
    >>> patch.shape, round(patch.figures["boundary_deviation"], 4)
    ((1.0, 1.0, 1.0, 1.0), 0.3324)
    """
    if shape is not None and search:
        raise BoundaryError("give shape or search, not both: a search finds the shape")
    method: dict[str, Any] = {"name": "GT", "basis": "gt", "energy": energy, "search-energy": search_energy}
    if patch != "tensor":
        method = {"name": "TB-Coons", "patch": patch, "energy": energy, "search-energy": search_energy}
    if shape is not None:
        method["shape"] = _numbers(shape, "shape")
    else:
        method["search"] = True if search is None else search
    swarm = {
        "variant": variant,
        "particles": particles,
        "iterations": iterations,
        "runs": runs,
        "inertia": inertia,
        "social": social,
        "cognitive": cognitive,
        "box": box,
        "neighbours": neighbours,
    }
    swarm = {key: value for key, value in swarm.items() if value is not None}
    more = {"seed": seed, "search": swarm} if swarm else {"seed": seed}
    return _solved(_sides(u0, u1, v0, v1), method, degree, more, progress)


def triangle(
    ab: npt.ArrayLike,
    bc: npt.ArrayLike,
    ca: npt.ArrayLike,
    *,
    energy: str | None = None,
    mask: float | str | None = None,
    construction: str | None = None,
    degree: int | None = None,
    metric_steps: int | None = None,
    tolerance: float | None = None,
    domain: str | None = None,
    progress: Told | None = None,
) -> Surface:
    """The triangular Bézier patch over three sides, of least area unless something else is asked for.

    Args:
        ab, bc, ca: control points of the sides, shape (n + 1, 3), one after the other round.
        energy: what the interior minimises, as in :func:`extremal`; ``"area"`` by default.
        mask: instead, a corner weight, ``"dirichlet"`` or ``"coons"``.
        construction: instead, ``"discrete-coons"``, which raises the degree by one.
        degree: of the patch, 18 at most for the least area; by default that of the sides.
        metric_steps, tolerance: as in :func:`dirichlet` and :func:`least_area`.
        domain: the plane triangle over which a quadratic energy is taken, ``"right"`` or ``"equilateral"``.

    >>> import plateau_patches as pp
    >>> a, b, c = [0, 0, 0], [1, 0, 0], [0, 1, 0]
    >>> flat = pp.triangle([a, [0.5, 0, 0], b], [b, [0.5, 0.5, 0], c], [c, [0, 0.5, 0], a], degree=3)
    >>> round(flat.area, 9), flat.net.shape, flat.indices[0].tolist()
    (0.5, (10, 3), [0, 0, 3])
    """
    if energy is None and mask is None and construction is None:
        energy = "area"
    method = {
        "name": "Triangle",
        "energy": energy,
        "mask": mask,
        "construction": construction,
        "metric-steps": metric_steps,
        "tolerance": tolerance,
        "domain": domain,
    }
    return _solved(_sides_of({"ab": ab, "bc": bc, "ca": ca}), method, degree, progress=progress)


def helicoid(a: float = 1.0, b: float = 0.0, *, u_span: float, v_span: float) -> Surface:
    """The helicoid x = a sinh u cos v − b cosh u sin v, y = a sinh u sin v + b cosh u cos v, z = a v + b u over
    [0, u_span] × [0, v_span], exact: (1, 0) is the right helicoid, (0, 1) the catenoid.

    >>> import plateau_patches as pp
    >>> pp.helicoid(1.0, 2.0, u_span=1.5, v_span=6.0).figures["deviation"] < 1e-9
    True
    """
    table = {"a": float(a), "b": float(b), "u-span": float(u_span), "v-span": float(v_span)}
    return _first(run({"title": "Helicoid", "helicoid": table}))


def deformation(
    frames: int = 11, *, u_span: float, v_span: float, path: str = "trigonometric"
) -> list[Surface]:
    """The helicoids from the right one to the catenoid, both included: isometric on the path ``"trigonometric"``, straight in
    (a, b) on ``"linear"``."""
    table = {"a": 1.0, "b": 0.0, "u-span": float(u_span), "v-span": float(v_span), "frames": frames, "path": path}
    results = run({"title": "Deformation", "helicoid": table})
    return [results[name] for name in list(results)[1:]]


def trapezium_helicoid(span: float, gamma: Sequence[float], beta: Sequence[float]) -> Surface:
    """The right helicoid (w cos v, w sin v, v) over the trapezium 0 ≤ v ≤ span, γ0 + β0 v ≤ w ≤ γ1 + β1 v, exact."""
    table = {"span": float(span), "gamma": _numbers(gamma, "gamma"), "beta": _numbers(beta, "beta")}
    return _first(run({"title": "Trapezium helicoid", "trapezium-helicoid": table}))


def _sides(u0: npt.ArrayLike, u1: npt.ArrayLike, v0: npt.ArrayLike, v1: npt.ArrayLike) -> dict[str, Any]:
    return _sides_of({"u0": u0, "u1": u1, "v0": v0, "v1": v1})


def _sides_of(sides: Mapping[str, npt.ArrayLike]) -> dict[str, Any]:
    return {name: points(side, name) for name, side in sides.items()}


def _numbers(values: Any, what: str) -> list[float]:
    try:
        return [number(value, what) for value in values]
    except TypeError:
        raise BoundaryError(f"{what} is {values!r}; a list of numbers is expected") from None


def _solved(
    boundary: dict[str, Any],
    method: Mapping[str, Any],
    degree: int | None,
    more: Mapping[str, Any] | None = None,
    progress: Told | None = None,
) -> Surface:
    method = {key: value for key, value in method.items() if value is not None}
    if degree is not None:
        given = max(len(side) - 1 for side in boundary.values())
        degree = whole(degree, "degree", 1, 64)
        if degree < given:
            raise BoundaryError(f"degree {degree} is not offered; give one from {given}, that of the sides, to 64")
        if degree > given:
            method["raise"] = degree - given
    experiment = {"title": method["name"], **(more or {}), "boundary": boundary, "method": [method]}
    return _first(run(experiment, progress=progress))


def _first(results: Mapping[str, Surface]) -> Surface:
    name = next(iter(results))
    try:
        return results[name]
    except MethodError as error:
        raise MethodError(str(error).removeprefix(f"{name}: ")) from None
