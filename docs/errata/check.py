"""check.py: what the errata say of formulas, computed anew beside what is printed. Needs mpmath; none of our code takes part.

Each check fails if the corrected form is wrong, or if the printed one is right."""

from fractions import Fraction

from mpmath import cos, cosh, diff, findroot, matrix, mp, mpf, norm, pi, quad, sin, sinh

mp.dps = 30
TINY = mpf(10) ** -20
count = 0


def proves(what, right, printed):
    """`right` is the error of the corrected form, `printed` that of the form in print."""
    global count
    right, printed = (mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x) for x in (right, printed))
    assert abs(right) < TINY, (what, "corrected form", right)
    assert abs(printed) > 1e-6, (what, "printed form", printed)
    count += 1
    print(f"  {what}: corrected form exact, printed form off by {float(abs(printed)):.3g}")


# The functions of order 6, from F (AHT section 3, AT section 2.1).


def family(F, alpha):
    """b_0 … b_5 on [0, alpha], and the numbers f_i, e, g, h of both papers."""
    f = [diff(F, alpha, i) for i in range(5)]
    e, g, h = f[1] ** 2 - f[0] * f[2], f[0] * f[3] - f[1] * f[2], f[2] ** 2 - f[1] * f[3]
    H = h / ((f[2] * h + f[3] * g + f[4] * e) * e)
    upper = [
        lambda t: H * (h * F(t) + g * diff(F, t) + e * diff(F, t, 2)),
        lambda t: f[1] / e * (diff(F, t) - f[1] * F(t) / f[0]),
        lambda t: F(t) / f[0],
    ]
    lower = [lambda t, b=b: b(alpha - t) for b in reversed(upper)]
    return lower + upper, f, (e, g, h)


def off(basis, points, phi, alpha):
    """How far the curve of control values `points` is from phi."""
    at = [alpha * k / 7 for k in range(8)]
    return max(abs(sum(b(t) * p for b, p in zip(basis, points)) - phi(t)) for t in at)


def aht():
    alpha = mpf(3) / 2
    basis, f, (e, g, h) = family(lambda t: (sinh(t) + sin(t)) / 2 - t, alpha)
    delta = f[0] / f[1]

    def of_cosh(M, L):
        s, c = sinh(alpha), cosh(alpha)
        return [1, 1, L, L * c - M * s, c - delta * s, c]

    def of_cos(M, N):
        s, c = sin(alpha), cos(alpha)
        return [1, 1, N, N * c + M * s, c + delta * s, c]

    # Printed: M = g/h, L = (h - 2 f1 g + f0 h)/h, N = (h + 2 f1 g - f0 h)/h.
    printed_l, printed_n = (h - 2 * f[1] * g + f[0] * h) / h, (h + 2 * f[1] * g - f[0] * h) / h
    proves("AHT control points, M and L", off(basis, of_cosh(-g / h, 1 + e / h), cosh, alpha), off(basis, of_cosh(g / h, printed_l), cosh, alpha))
    proves("AHT control points, M and N", off(basis, of_cos(-g / h, 1 - e / h), cos, alpha), off(basis, of_cos(g / h, printed_n), cos, alpha))

    bound = findroot(lambda a: cos(a) * cosh(a) - 1, mpf("7.8532"))
    late, _, _ = family(lambda t: (sinh(t) + sin(t)) / 2 - t, mpf("7.85321"))
    least = min(late[3](mpf("7.85321") * k / 16) for k in range(1, 16))
    assert bound < 5 * pi / 2 and least < 0, (bound, least)
    print(f"  AHT domain: the bound is {mp.nstr(bound, 16)} < 5 pi/2; at 7.85321 b_3 falls to {float(least):.3g}")

    a, b, u, v = mpf(1), mpf(2), mpf("0.7"), mpf("0.4")
    x = [
        lambda u, v: a * sinh(u) * cos(v) - b * cosh(u) * sin(v),
        lambda u, v: a * sinh(u) * sin(v) + b * cosh(u) * cos(v),
        lambda u, v: a * v + b * u,
    ]
    du, dv = [[diff(c, (u, v), n) for c in x] for n in [(1, 0), (0, 1)]]
    E, F, G = (sum(p * q for p, q in zip(*pair)) for pair in [(du, du), (du, dv), (dv, dv)])
    proves("AHT isothermal: E = G, F = 0; printed E = F, G = 0", max(abs(E - G), abs(F)), max(abs(E - F), abs(G)))


def at():
    def F(t):
        return 3 * (t - sin(t)) - t * (1 - cos(t))

    alpha = +pi
    basis, f, (e, g, h) = family(F, alpha)
    g1 = 1 - cos(alpha)
    d = g + alpha * h
    delta, M, eps = f[0] / f[1], -g / h, e / h
    phi = [lambda t: t * cos(t), lambda t: cos(t) - t * sin(t), lambda t: -2 * sin(t) - t * cos(t)]
    right = phi[0](alpha) - M * phi[1](alpha) + eps * phi[2](alpha)
    points = [0, delta, M, right, phi[0](alpha) - delta * phi[1](alpha), phi[0](alpha)]
    printed = points[:3] + [2 * (3 * f[0] * g1 - 2 * d) / h] + points[4:]
    corrected = points[:3] + [2 * (3 * f[0] * g1 - d) / h] + points[4:]
    proves("AT (0.2), x of P_3", off(basis, corrected, phi[0], alpha), off(basis, printed, phi[0], alpha))
    print(f"    at alpha = pi: printed {mp.nstr(printed[3], 5)}, right {mp.nstr(right, 4)}")

    proves(
        "AT basis, u_4 from F' and u_5; printed F and u_0",
        off(basis, [1] * 6, lambda t: mpf(1), alpha),
        max(abs(f[1] / e * (F(t) - f[1] * basis[0](t)) - basis[4](t)) for t in [alpha / 3, alpha / 2]),
    )

    # Theorem 3: two points in u need functions of degree 1; of degree 2 there are three, and the first two do not sum to 1.
    u = mpf("0.3")
    proves("AT Theorem 3, B_{j,1}", (1 - u) + u - 1, (1 - u) ** 2 + 2 * u * (1 - u) - 1)

    # The helicoid over a trapezium: z is v on both sides, whatever the slope.
    beta = mpf("0.5")
    z = [0, delta, M, alpha - M, alpha - delta, alpha]
    proves("AT control points, z", off(basis, z, lambda t: t, alpha), off(basis, [beta * p for p in z], lambda t: t, alpha))


# Triangular nets: exact rational arithmetic.


def rank(rows):
    rows, found = [row[:] for row in rows], 0
    for column in range(len(rows[0])):
        pivot = next((r for r in range(found, len(rows)) if rows[r][column] != 0), None)
        if pivot is None:
            continue
        rows[found], rows[pivot] = rows[pivot], rows[found]
        for r in range(found + 1, len(rows)):
            factor = rows[r][column] / rows[found][column]
            if factor:
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[found])]
        found += 1
    return found


def mask_rank(n, weights):
    """Rank and order of the system that a mask makes of the interior of a net of degree n."""
    inside = [(i, j, n - i - j) for i in range(1, n) for j in range(1, n - i)]
    place = {index: k for k, index in enumerate(inside)}
    rows = []
    for index in inside:
        row = [Fraction(0)] * len(inside)
        row[place[index]] += 1
        for step, weight in weights.items():
            there = place.get(tuple(a + b for a, b in zip(index, step)))
            if there is not None:
                row[there] -= weight
        rows.append(row)
    return rank(rows), len(inside)


def masks():
    half = Fraction(1, 2)
    coons = {(-1, 0, 1): half, (-1, 1, 0): -half, (0, -1, 1): half, (0, 1, -1): half, (1, -1, 0): -half, (1, 0, -1): half}
    singular = [n for n in range(3, 13) if len(set(mask_rank(n, coons))) > 1]
    assert singular == [6, 8, 10, 12], singular
    print(f"  COONS Prop. 4: of the degrees 3 to 12 the system is singular at {singular}")
    alpha = Fraction(-2, 3)
    beta = (1 - 3 * alpha) / 6
    corners = [(2, -1, -1), (-1, 2, -1), (-1, -1, 2)]
    edges = [(1, -1, 0), (1, 0, -1), (-1, 1, 0), (0, 1, -1), (-1, 0, 1), (0, -1, 1)]
    symmetric = {**{step: alpha for step in corners}, **{step: beta for step in edges}}
    singular = [n for n in range(3, 13) if len(set(mask_rank(n, symmetric))) > 1]
    assert singular == [4, 10], singular
    print(f"  symmetric mask M_(-2/3): of the degrees 3 to 12 the system is singular at {singular}")


def coons():
    # Discrete Coons patch (COONS section 2): over the border of a net that is linear in j it is that net.
    m, n = 3, 5

    def net(i, j, divisor):
        border = lambda i, j: Fraction(i * i * j)
        s, t = Fraction(i, m), Fraction(j, divisor)
        across = (1 - s) * border(0, j) + s * border(m, j) + (1 - t) * border(i, 0) + t * border(i, n)
        corners = (1 - s) * ((1 - t) * border(0, 0) + t * border(0, n)) + s * ((1 - t) * border(m, 0) + t * border(m, n))
        return across - corners - border(i, j)

    proves("COONS section 2, 1 - j/n; printed 1 - j/m", net(1, 2, n), net(1, 2, m))
    # The integral of a Bernstein polynomial of degree N over the triangle, for products of second derivatives: N = 2n - 4.
    n, (i, j, k) = 4, (1, 1, 2)
    value = quad(lambda u: quad(lambda v: 12 * u * v * (1 - u - v) ** 2, [0, 1 - u]), [0, 1])
    proves("COONS Prop. 2, the integral", value - mpf(1) / ((2 * n - 3) * (2 * n - 2)), value - mpf(1) / ((3 * n - 2) * (3 * n - 3)))


def enneper():
    """TRI: the Dirichlet extremal over a scalene piece of Enneper's surface is not that piece; over a right isosceles one it is."""

    def x(p):
        u, v = p
        return [u - u**3 / 3 + u * v * v, v - v**3 / 3 + v * u * u, u * u - v * v]

    def controls(a, b, c):
        """The ten control points: interpolation at the points of a cubic net."""
        index = [(i, j, 3 - i - j) for i in range(4) for j in range(4 - i)]
        bernstein = lambda at: [mpf(6) / (mp.fac(i) * mp.fac(j) * mp.fac(k)) * mpf(at[0]) ** i * mpf(at[1]) ** j * mpf(at[2]) ** k for i, j, k in index]
        system, values = matrix(10, 10), matrix(10, 3)
        for row, at in enumerate(index):
            at = [mpf(w) / 3 for w in at]
            point = [sum(w * corner[d] for w, corner in zip(at, (a, b, c))) for d in range(2)]
            for column, value in enumerate(bernstein(at)):
                system[row, column] = value
            for d, value in enumerate(x(point)):
                values[row, d] = value
        solved = system**-1 * values
        return {place: [solved[row, d] for d in range(3)] for row, place in enumerate(index)}

    def middle_off(a, b, c):
        P = controls(a, b, c)
        rule = {(0, 0, 3): 2, (0, 2, 1): -1, (0, 3, 0): 1, (1, 2, 0): 1, (2, 0, 1): -1, (2, 1, 0): 1, (3, 0, 0): 1}
        middle = [sum(w * P[place][d] for place, w in rule.items()) / 4 for d in range(3)]
        return norm([p - q for p, q in zip(middle, P[1, 1, 1])])

    right = middle_off([mpf(1), mpf(0)], [mpf(0), mpf(1)], [mpf(0), mpf(0)])
    scalene = middle_off([mpf("1.3"), mpf("0.2")], [mpf("0.1"), mpf("0.9")], [mpf("-0.4"), mpf("-0.3")])
    proves("TRI section 6: only conformal pieces of Enneper are reproduced", right, scalene)


def harmonic():
    """GT (6.5): the factors n(n-1) and m(m-1) are too many where m and n differ."""
    # Control points of Re((u + iv)^2) = u² - v² of degree (m, n) = (2, 4), i with u.
    m, n = 2, 4
    P = [[Fraction(i * (i - 1), m * (m - 1)) - Fraction(j * (j - 1), n * (n - 1)) for j in range(n + 1)] for i in range(m + 1)]

    def relation(i, j, factors):
        def second(i, j, along_u):
            k, top = (i, m) if along_u else (j, n)
            if k < 0 or k + 2 > top:
                return Fraction(0)
            points = [P[i + s][j] if along_u else P[i][j + s] for s in range(3)]
            return points[2] - 2 * points[1] + points[0]

        def side(k, top, along_u):
            a, b, c = (top - k) * (top - k - 1), 2 * k * (top - k), k * (k - 1)
            at = lambda back: second(i - back, j, True) if along_u else second(i, j - back, False)
            return a * at(0) + b * at(1) + c * at(2)

        return factors[0] * side(i, m, True) + factors[1] * side(j, n, False)

    both = [
        max(abs(relation(i, j, factors)) for i in range(m + 1) for j in range(n + 1))
        for factors in [(1, 1), (m * (m - 1), n * (n - 1))]
    ]
    proves("GT (6.5): no factors in front", both[0], both[1])


for title, part in [("AHT", aht), ("AT", at), ("masks", masks), ("COONS", coons), ("TRI", enneper), ("GT", harmonic)]:
    print(title)
    part()
print(f"{count} corrected formulas exact where the printed ones are not")
