"""Verifies the lower bounds of area in result.json without our code: certificate.py RESULT.json… (needs mpmath).

A certificate cuts the region below the rim into faces, each the projection (x, y) of a Bézier patch to a plane, and gives a potential
ψ(x, y) on them. If |∇ψ| ≤ 1, the field (−ψ_y, ψ_x, √(1 − |∇ψ|²)) has length 1 and no divergence; its flux through a graph z is at most
the graph's area, and depends only on the rim: ∮ z dψ + ∫ √(1 − |∇ψ|²) dx dy. Over a convex region the field, continued by the nearest
point of the region, bounds every oriented surface with the rim, since the projection to the cylinder over it enlarges no area.

What is shown here, from the numbers as they stand in the file:
- the axes are orthonormal up to δ, and areas are divided by 1 + δ;
- faces meet along whole edges, in opposite directions, with the same ψ; the edges of one face make up the rim of the surface, whole
  or each in halves;
- in the parameters (u, v) of a face, D = x_u y_v − x_v y_u > 0 and q = D² − |ψ_u y_v − ψ_v y_u|² − |ψ_v x_u − ψ_u x_v|² > 0, as their
  Chebyshev coefficients on parts of the square show: all others together are smaller than the first;
- ∫ √(1 − |∇ψ|²) dx dy = ∫ √q du dv by Gauss' rule of N² points. With coefficients c_jk and ρ > 1 such that Σ |c_jk| ρ^j < 2 c_00, q has
  positive real part for u in the ellipse with foci ±1 and semiaxes (ρ ± 1/ρ)/2, so that √q is analytic there and at most M = √(2 c_00):
  its Chebyshev coefficients are at most 2 M ρ^−k, and the rule, exact to degree 2N − 1, errs by at most 4 M ρ^(−2N) / (1 − 1/ρ).
All in 60 digits; what is added up in great number, in whole multiples of 2^−180 of a unit about the size of the surface.
"""

import json
import sys
from fractions import Fraction
from itertools import chain
from math import atan2, comb, frexp, hypot, isfinite, isqrt, pi
from operator import mul

from mpmath import mp, mpf

mp.dps = 60
BITS = 180
ROUNDING = mpf(10) ** -35
DEEPEST = 9
POINTS = (12, 20, 32, 48)
RADII = [mpf(r) for r in ("12", "8", "6", "4.5", "3.5", "3", "2.5", "2.2", "1.9", "1.7", "1.5", "1.35")]
SURFACES = "every surface with this rim"
GRAPHS = "every graph over this plane with this rim"


class Refused(Exception):
    pass


def demand(holds, why):
    if not holds:
        raise Refused(why)


# Polynomials


def bernstein(n, t, order=0):
    """The values, or first derivatives, of the Bernstein polynomials of degree n at t."""
    if order == 0:
        return [comb(n, k) * t**k * (1 - t) ** (n - k) for k in range(n + 1)]
    lower = bernstein(n - 1, t) if n else []
    return [n * ((lower[k - 1] if k else 0) - (lower[k] if k < n else 0)) for k in range(n + 1)]


def fixed(matrix):
    """Numbers as whole multiples of 2^−BITS."""
    return [[int(mp.ldexp(mpf(c), BITS)) for c in row] for row in matrix]


def product(left, net, right):
    """left · net · rightᵀ, all in fixed point."""
    across = [[sum(map(mul, row, line)) >> BITS for line in right] for row in net]
    columns = list(zip(*across))
    return [[sum(map(mul, row, column)) >> BITS for column in columns] for row in left]


class Face:
    """The planar map and the potential of a face."""

    def __init__(self, places, potential):
        self.x, self.y, self.z = ([[p[c] for p in row] for row in places] for c in range(3))
        self.psi = potential
        self.nets = [fixed(net) for net in (self.x, self.y, self.psi)]
        n = max(len(places), len(places[0])) - 1
        d = max(len(potential), len(potential[0])) - 1
        self.degree = 2 * max(2 * n - 1, n + d - 1)

    def forms(self, us, vs):
        """D and q on a grid, in fixed point."""
        tables = {}

        def table(at, n, order):
            if (id(at), n, order) not in tables:
                tables[id(at), n, order] = fixed([bernstein(n, t, order) for t in at])
            return tables[id(at), n, order]

        def by(net, du, dv):
            return product(table(us, len(net) - 1, du), net, table(vs, len(net[0]) - 1, dv))

        fields = [by(net, *d) for net in self.nets for d in ((1, 0), (0, 1))]
        jacobian, square = [], []
        for rows in zip(*fields):
            line = [(xu * yv - xv * yu) >> BITS for xu, xv, yu, yv, _, _ in zip(*rows)]
            slopes = [((pu * yv - pv * yu) >> BITS, (pv * xu - pu * xv) >> BITS) for xu, xv, yu, yv, pu, pv in zip(*rows)]
            jacobian.append(line)
            square.append([(d * d - a * a - b * b) >> BITS for d, (a, b) in zip(line, slopes)])
        return jacobian, square


_chebyshev = {}


def chebyshev_nodes(n):
    """The n Chebyshev nodes of [0, 1], and the matrix that takes values there to coefficients."""
    if n not in _chebyshev:
        angles = [mp.pi * (2 * k + 1) / (2 * n) for k in range(n)]
        matrix = [[(2 if j else 1) * mp.cos(j * a) / n for a in angles] for j in range(n)]
        _chebyshev[n] = [(1 + mp.cos(a)) / 2 for a in angles], fixed(matrix)
    return _chebyshev[n]


_gauss = {}


def gauss(n):
    """Gauss' rule of n points on [0, 1]."""
    if n not in _gauss:
        rule = []
        for k in range(n):
            x = mp.cos(mp.pi * (k + mpf(3) / 4) / (n + mpf(1) / 2))
            for _ in range(20):
                p, below = x, mpf(1)
                for m in range(2, n + 1):
                    p, below = ((2 * m - 1) * x * p - (m - 1) * below) / m, p
                slope = n * (x * p - below) / (x * x - 1)
                x, last = x - p / slope, p / slope
                if abs(last) < mpf(10) ** -55:
                    break
            rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope**2)))
        _gauss[n] = rule
    return _gauss[n]


# The integral


def remainder(coefficients, direction):
    """The number of points with the error of Gauss' rule in one direction; none if √q is not shown to be smooth enough."""
    rows = coefficients if direction == 0 else zip(*coefficients)
    sums = [mp.ldexp(sum(map(abs, row)), -BITS) for row in rows]
    first = mp.ldexp(coefficients[0][0], -BITS)
    best = None
    for radius in RADII:
        if sum(s * radius**j for j, s in enumerate(sums)) < 2 * first:
            for points in POINTS:
                error = 4 * mp.sqrt(2 * first) * radius ** (-2 * points) / (1 - 1 / radius)
                if error < mpf(10) ** -16 * mp.sqrt(first):
                    return points, error
            best = best or (POINTS[-1], error)
    return best if best and best[1] < mpf(10) ** -14 * mp.sqrt(first) else None


def root_integral(face, corner, size, depth=0):
    """A lower bound of ∫ √q over a square part of a face."""
    nodes, matrix = chebyshev_nodes(face.degree + 1)
    us, vs = ([c + size * t for t in nodes] for c in corner)
    jacobian, square = face.forms(us, vs)
    rules = None
    of_d, of_q = (product(matrix, values, matrix) for values in (jacobian, square))
    if all(all_but_first(c) < c[0][0] * (1 - ROUNDING) - 2 ** (BITS // 2) for c in (of_d, of_q)):
        rules = remainder(of_q, 0), remainder(of_q, 1)
    if rules is None or None in rules:
        demand(depth < DEEPEST, "D or 1 − |∇ψ|² is not shown to be positive on a face")
        half = size / 2
        corners = [(corner[0] + a * half, corner[1] + b * half) for a in (0, 1) for b in (0, 1)]
        # What is not positive somewhere need not be cut to the end.
        demand(min(map(min, jacobian)) > 0, "a face is turned over: no graph over the plane")
        demand(min(map(min, square)) > 0, "|∇ψ| exceeds 1")
        return sum(root_integral(face, c, half, depth + 1) for c in corners)
    (points_u, error_u), (points_v, error_v) = rules
    along_u, along_v = gauss(points_u), gauss(points_v)
    _, square = face.forms([corner[0] + size * t for t, _ in along_u], [corner[1] + size * t for t, _ in along_v])
    across = fixed([[b for _, b in along_v]])[0]
    total = mpf(0)
    for (_, a), row in zip(along_u, square):
        total += a * (sum(b * isqrt(q << BITS) for b, q in zip(across, row)) >> BITS)
    return size**2 * (mp.ldexp(total, -BITS) * (1 - ROUNDING) - error_u - error_v)


def all_but_first(coefficients):
    return sum(abs(c) for row in coefficients for c in row) - abs(coefficients[0][0])


# Edges


def sides(net):
    """The four sides of a net in the order of a walk around it."""
    return [row[0] for row in net], list(net[-1]), [row[-1] for row in reversed(net)], list(reversed(net[0]))


def edges(nets, potentials=None):
    """The edges of one face as lists of (points, face, side); edges of two are checked."""
    found = {}
    for k, net in enumerate(nets):
        values = sides(potentials[k]) if potentials else [None] * 4
        for number, (side, psi) in enumerate(zip(sides(net), values)):
            key = tuple(map(tuple, side))
            forwards = key <= key[::-1]
            found.setdefault(min(key, key[::-1]), []).append((forwards, psi, k, number))
    rim = []
    for key, uses in found.items():
        demand(len(uses) <= 2, "three faces meet at an edge")
        if len(uses) == 1:
            forwards, _, k, number = uses[0]
            rim.append((list(key if forwards else key[::-1]), k, number))
        else:
            (a, first, *_), (b, second, *_) = uses
            demand(a != b, "two faces are turned differently")
            if potentials:
                demand(first == second[::-1], "ψ jumps across an edge")
    return rim


def raised(curve, degree):
    while len(curve) <= degree:
        n = len(curve)
        ends = [[Fraction(0)] * 3] + curve + [[Fraction(0)] * 3]
        curve = [[(k * a + (n - k) * b) / n for a, b in zip(ends[k], ends[k + 1])] for k in range(n + 1)]
    return curve


def distance(a, b):
    """The largest distance of the control points of two curves in one degree."""
    degree = max(len(a), len(b)) - 1
    exact = [raised([[Fraction(c) for c in p] for p in curve], degree) for curve in (a, b)]
    return max(hypot(*(float(s - t) for s, t in zip(p, q))) for p, q in zip(*exact))


def halves(curve):
    """The two halves of a curve, exactly."""
    row, left, right = [[Fraction(c) for c in p] for p in curve], [], []
    while row:
        left.append(row[0])
        right.insert(0, row[-1])
        row = [[(s + t) / 2 for s, t in zip(p, q)] for p, q in zip(row, row[1:])]
    return left, right


def length(curve):
    return sum(hypot(*(s - t for s, t in zip(p, q))) for p, q in zip(curve, curve[1:]))


def rim_moved(rim, surface, size):
    """What the area may change by between the rim of the certificate and that of the surface."""
    left, moved = [curve for curve, *_ in surface], 0.0
    if len(rim) == 2 * len(left):
        left = [half for curve in left for half in halves(curve)]
    demand(len(rim) == len(left), "the rim is not that of the surface")
    for curve, *_ in rim:
        apart = [(min(distance(curve, other), distance(curve, other[::-1])), k) for k, other in enumerate(left)]
        nearest, k = min(apart)
        demand(nearest <= 1e-13 * size, "the rim is not that of the surface")
        moved += 2 * nearest * length(curve)
        del left[k]
    return moved


def is_convex(rim, place):
    """Whether the rim is one loop whose control polygon turns left all the way, once, but for rounding."""
    pieces = [curve for curve, *_ in rim]
    polygon, at = [], pieces.pop(0)
    start = at[0]
    while True:
        polygon += at[:-1]
        if at[-1] == start:
            break
        following = [k for k, piece in enumerate(pieces) if piece[0] == at[-1]]
        if len(following) != 1:
            return False
        at = pieces.pop(following[0])
    flat = [place(p)[:2] for p in polygon]
    steps = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(flat, flat[1:] + flat[:1])]
    steps = [s for s in steps if s != (0, 0)]
    turned = 0.0
    for a, b in zip(steps, steps[1:] + steps[:1]):
        cross, along = float(a[0] * b[1] - a[1] * b[0]), float(a[0] * b[0] + a[1] * b[1])
        if cross < -1e-13 * (float(mp.hypot(*a)) + float(mp.hypot(*b))):
            return False
        turned += atan2(max(cross, 0.0), along)
    return not pieces and abs(turned - 2 * pi) < 1e-6


# The certificate


def verify(method):
    """The bound that the certificate of a method proves. Raises Refused."""
    proof = method["lower_bound_proof"]
    origin, axes = proof["plane"]["origin"], proof["plane"]["axes"]
    gram = [[sum(Fraction(s) * Fraction(t) for s, t in zip(a, b)) for b in axes] for a in axes]
    skew = max(sum(abs(g - (i == j)) for j, g in enumerate(row)) for i, row in enumerate(gram))
    demand(skew < 1e-12, "the axes are not orthonormal")

    nets, potentials = ([face[key] for face in proof["faces"]] for key in ("net", "potential"))
    written = [*origin, *chain(*axes), *chain(*chain(*chain(*nets))), *chain(*chain(*potentials)), method["lower_bound"]]
    demand(all(map(isfinite, written)), "a number of it is none")
    points = [p for net in nets for row in net for p in row]
    size = max(hypot(*(a - b for a, b in zip(p, points[0]))) for p in points)
    demand(size > 0, "the surface is a point")
    unit = mpf(2) ** frexp(size)[1]

    def place(point):
        away = [(mpf(p) - mpf(o)) / unit for p, o in zip(point, origin)]
        return tuple(mp.fdot(map(mpf, axis), away) for axis in axes)

    rim = edges(nets, potentials)
    surface = [face["net"] for face in method["faces"]] if "faces" in method else [method["net"]]
    moved = rim_moved(rim, edges(surface), size)
    demand(proof["holds_for"] in (SURFACES, GRAPHS), "it is not said which surfaces are bounded")
    if proof["holds_for"] == SURFACES:
        demand(is_convex(rim, place), "the rim is not convex over the plane: surfaces that are no graphs are not bounded")
    faces = [
        Face([[place(p) for p in row] for row in net], [[mpf(c) / unit for c in row] for row in psi])
        for net, psi in zip(nets, potentials)
    ]
    total = sum(root_integral(face, (mpf(0), mpf(0)), mpf(1)) for face in faces)
    for _, k, number in rim:
        z, psi = sides(faces[k].z)[number], sides(faces[k].psi)[number]
        for t, weight in gauss((len(z) + len(psi)) // 2 + 1):
            total += weight * mp.fdot(bernstein(len(z) - 1, t), z) * mp.fdot(bernstein(len(psi) - 1, t, 1), psi)
    bound = (total - ROUNDING) * unit**2 / (1 + mpf(float(skew)) * 2) - moved
    claimed = method["lower_bound"]
    demand(claimed <= bound, f"{claimed!r} is claimed, {mp.nstr(bound, 17)} is proved")
    return bound


def main(files):
    sound = True
    for file in files:
        for method in json.load(open(file))["methods"]:
            if "lower_bound" not in method:
                continue
            try:
                bound = verify(method)
                print(f"confirmed: {file}: {method['name']}: {method['lower_bound']!r}, {method['lower_bound_proof']['holds_for']}")
                print(f"           (shown here: {mp.nstr(bound, 17)}; area of the surface {method['area']!r})")
            except Refused as why:
                print(f"refused: {file}: {method['name']}: {why}")
                sound = False
    return 0 if sound else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
