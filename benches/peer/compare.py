"""The search of GT Example 5.1 by NumPy, pyswarms and SciPy, beside ours in the same sitting.

    compare.py PATH-OF-search_time

Ten runs of a swarm of 50 particles over 100 iterations in the box [0.5, 3.5]^4, and ten descents from random starts, all
on the same reduced energy J. To be fair to NumPy it gets every idea ours has: the GT functions are affine in their
parameters, so with the boundary contracted once all numbers that J is made from are bilinear forms in six monomials of
(a1, a2) and six of (b1, b2). All particles are evaluated by one matrix product. The plain way, which assembles the matrix
of every particle, is timed too.

One thread everywhere unless said otherwise; ours runs before and after the others. Two ratios: of median wall times, and
of the least times, which a busy machine disturbs less (for Python the least processor time, for ours still wall time).
"""

import os

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[variable] = "1"

import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy
from scipy.optimize import minimize

RUNS, PARTICLES, ITERATIONS = 10, 50, 100
LOWER, UPPER = 0.5, 3.5
INERTIA, SOCIAL, COGNITIVE = 0.7, 1.5, 1.5
MINIMUM = 37.4395611966
FREE = [5, 6, 9, 10]
FIXED = [k for k in range(16) if k not in FREE]


def boundary():
    """The control net of Example 5.1, 16 x 3, zero inside."""
    net = np.zeros((4, 4, 3))
    for k, height in enumerate([0.0, 2.0, -2.0, 0.0]):
        net[0, k] = [2 * k, 0, height]
        net[3, k] = [2 * k, 6, height]
        net[k, 0] = [0, 2 * k, height]
        net[k, 3] = [6, 2 * k, height]
    return net.reshape(16, 3)


def gt_parts(t):
    """Values and derivatives of the cubic GT functions at t: arrays (points, 3 affine parts, 4)."""
    s, c = np.sin(np.pi / 2 * t), np.cos(np.pi / 2 * t)
    ds, dc = np.pi / 2 * c, -np.pi / 2 * s
    values, slopes = np.zeros((2, t.size, 3, 4))
    for part, (t1, t2) in enumerate([(0, 0), (1, 0), (0, 1)]):
        first = 1 - s * s - t1 / 2 * s * (1 - s)
        last = 1 - c * c - t2 / 2 * c * (1 - c)
        d_first = -2 * s * ds - t1 / 2 * ds * (1 - 2 * s)
        d_last = -2 * c * dc - t2 / 2 * dc * (1 - 2 * c)
        seeds = [(first, d_first), (1 - first - last, -d_first - d_last), (last, d_last)]
        for j, (g, dg) in enumerate(seeds):
            values[:, part, j] += (1 - t) * g
            values[:, part, j + 1] += t * g
            slopes[:, part, j] += (1 - t) * dg - g
            slopes[:, part, j + 1] += t * dg + g
    for table in (values, slopes):
        table[:, 1:] -= table[:, :1]
    return values, slopes


def gram_polynomials():
    """Coefficients (6, 4, 4) of the mass and of the stiffness matrix by 1, t1, t2, t1^2, t1 t2, t2^2."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    grams = []
    for table in gt_parts((nodes + 1) / 2):
        products = np.einsum("p,pai,pbj->abij", weights / 2, table, table)
        both = lambda a, b: products[a, b] + products[b, a]
        grams.append(
            np.array([products[0, 0], both(0, 1), both(0, 2), products[1, 1], both(1, 2), products[2, 2]])
        )
    return grams


def monomials(s, t):
    return np.stack([np.ones_like(s), s, t, s * s, s * t, t * t], axis=-1)


class Assembled:
    """J of many particles, each with its own 16 x 16 matrix."""

    def __init__(self):
        self.mass, self.stiffness = gram_polynomials()
        self.net = boundary()

    def __call__(self, points):
        x, y = monomials(points[:, 0], points[:, 1]), monomials(points[:, 2], points[:, 3])
        at = lambda x, gram: (x @ gram.reshape(6, 16)).reshape(-1, 4, 4)
        ku, mu, kv, mv = at(x, self.stiffness), at(x, self.mass), at(y, self.stiffness), at(y, self.mass)
        q = 0.5 * (
            np.einsum("pik,pjl->pijkl", ku, mv) + np.einsum("pik,pjl->pijkl", mu, kv)
        ).reshape(-1, 16, 16)
        fixed = self.net[FIXED]
        b = q[:, FREE][:, :, FIXED] @ fixed
        inner = np.linalg.solve(q[:, FREE][:, :, FREE], b)
        outer = np.einsum("id,pij,jd->p", fixed, q[:, FIXED][:, :, FIXED], fixed)
        return outer - (b * inner).sum(axis=(1, 2))


class Contracted:
    """J of many particles from one product with a table: 10 entries of the 4 x 4 matrix, 12 of b, and c."""

    def __init__(self):
        mass, stiffness = gram_polynomials()
        q = 0.5 * (
            np.einsum("xik,yjl->xyijkl", stiffness, mass) + np.einsum("xik,yjl->xyijkl", mass, stiffness)
        ).reshape(36, 16, 16)
        fixed = boundary()[FIXED]
        matrix = q[:, FREE][:, :, FREE]
        b = q[:, FREE][:, :, FIXED] @ fixed
        c = np.einsum("id,pij,jd->p", fixed, q[:, FIXED][:, :, FIXED], fixed)
        self.full = np.hstack([matrix.reshape(36, 16), b.reshape(36, 12), c[:, None]])
        # Rows of the lower triangle and of b, then c: the order of the elimination below.
        self.table = np.vstack([matrix[:, i, j] for j in range(4) for i in range(j, 4)] + list(b.reshape(36, 12).T) + [c])

    def _entries(self, points):
        """The entries of all particles, one row an entry."""
        a1, a2, b1, b2 = points.T
        x = np.stack([np.ones_like(a1), a1, a2, a1 * a1, a1 * a2, a2 * a2])
        y = np.stack([np.ones_like(b1), b1, b2, b1 * b1, b1 * b2, b2 * b2])
        return self.table @ (x[:, None] * y[None, :]).reshape(36, -1)

    def by_lapack(self, points):
        """The factorisation by LAPACK, matrix after matrix."""
        x, y = monomials(points[:, 0], points[:, 1]), monomials(points[:, 2], points[:, 3])
        entries = (x[:, :, None] * y[:, None, :]).reshape(-1, 36) @ self.full
        matrix, b = entries[:, :16].reshape(-1, 4, 4), entries[:, 16:28].reshape(-1, 4, 3)
        return entries[:, 28] - (b * np.linalg.solve(matrix, b)).sum(axis=(1, 2))

    def by_columns(self, points):
        """The factorisation by column operations on all particles at once."""
        e = self._entries(points)
        columns = [e[0:4], e[4:7], e[7:9], e[9:10]]
        rhs, value = e[10:22].reshape(4, 3, -1), e[22]
        for j in range(4):
            # What is left of column j, its diagonal first, and row j of b.
            pivot = columns[j][0]
            factors = columns[j][1:] / pivot
            value = value - (rhs[j] * rhs[j]).sum(axis=0) / pivot
            for k in range(j + 1, 4):
                columns[k] = columns[k] - factors[k - j - 1] * columns[j][k - j :]
            if j < 3:
                rhs[j + 1 :] -= factors[:, None] * rhs[j]
        return value

    def with_gradient(self, point):
        """J and its gradient at one point, by the envelope theorem."""
        a1, a2, b1, b2 = point
        x = np.array([1.0, a1, a2, a1 * a1, a1 * a2, a2 * a2])
        y = np.array([1.0, b1, b2, b1 * b1, b1 * b2, b2 * b2])
        entries = np.outer(x, y).ravel() @ self.full
        b = entries[16:28].reshape(4, 3)
        inner = -np.linalg.solve(entries[:16].reshape(4, 4), b)
        value = entries[28] + (b * inner).sum()
        weights = np.concatenate([(inner @ inner.T).ravel(), 2 * inner.ravel(), [1.0]])
        table = (self.full @ weights).reshape(6, 6)
        dx, dy = table @ y, x @ table
        by = lambda d, s, t: (d[1] + 2 * s * d[3] + t * d[4], d[2] + s * d[4] + 2 * t * d[5])
        return value, np.array(by(dx, a1, a2) + by(dy, b1, b2))


def swarm(objective, seed, swarms=1):
    """Our swarm in NumPy: the global variant, velocities zeroed at the walls; `swarms` of them side by side."""
    random = np.random.default_rng(seed)
    shape = (swarms, PARTICLES, 4)
    evaluate = lambda x: objective(x.reshape(-1, 4)).reshape(swarms, PARTICLES)
    x = random.uniform(LOWER, UPPER, shape)
    v = random.uniform(-0.1, 0.1, shape) * (UPPER - LOWER)
    own, own_values = x.copy(), evaluate(x)
    rows = np.arange(swarms)
    for _ in range(ITERATIONS):
        best = own[rows, own_values.argmin(axis=1)][:, None]
        pulls = random.random((2,) + shape)
        v = INERTIA * v + SOCIAL * pulls[0] * (best - x) + COGNITIVE * pulls[1] * (own - x)
        x = x + v
        inside = x.clip(LOWER, UPPER)
        v[inside != x] = 0.0
        x = inside
        values = evaluate(x)
        better = values < own_values
        own[better] = x[better]
        own_values = np.where(better, values, own_values)
    return own_values.min(axis=1)


def by_pyswarms(objective, seed):
    import pyswarms  # late, see main

    np.random.seed(seed)
    optimizer = pyswarms.single.GlobalBestPSO(
        n_particles=PARTICLES,
        dimensions=4,
        options={"w": INERTIA, "c1": SOCIAL, "c2": COGNITIVE},
        bounds=(np.full(4, LOWER), np.full(4, UPPER)),
        bh_strategy="nearest",  # the default, "periodic", misses this optimum every time
    )
    return optimizer.optimize(objective, ITERATIONS, verbose=False)[0]


def descents(objective):
    """Ten descents from random starts: values and evaluations."""
    random = np.random.default_rng(7)
    bounds = [(LOWER, UPPER)] * 4
    options = {"ftol": 1e-15, "gtol": 1e-9}
    return [
        minimize(objective, random.uniform(LOWER, UPPER, 4), jac=True, method="L-BFGS-B", bounds=bounds, options=options)
        for _ in range(RUNS)
    ]


def seconds(repeats, call):
    """Median wall time and least processor time of `repeats` calls, and what the last one returned."""
    call()
    walls, processor = [], []
    for _ in range(repeats):
        start, start_processor = time.perf_counter(), time.process_time()
        result = call()
        processor.append(time.process_time() - start_processor)
        walls.append(time.perf_counter() - start)
    return statistics.median(walls), min(processor), result


def ours(program):
    text = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    return dict(line.split(" ", 1) for line in text.splitlines())


def check(name, minimum):
    if abs(minimum - MINIMUM) > 1e-3:
        sys.exit(f"{name} found {minimum}, not {MINIMUM}: it does not search the same energy")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)  # pyswarms opens a report.log in the working directory as soon as it is imported
        import pyswarms

        compare(program, f"numpy {np.__version__}, scipy {scipy.__version__}, pyswarms {pyswarms.__version__}")
        os.chdir("/")


def compare(program, versions):
    assembled, contracted = Assembled(), Contracted()
    particles = np.random.default_rng(1).uniform(LOWER, UPPER, (PARTICLES, 4))
    known = assembled(particles)
    ways = {
        "assembled": assembled,
        "contracted, LAPACK": contracted.by_lapack,
        "contracted, by columns": contracted.by_columns,
    }
    print(versions + "\n")
    print("J of 50 particles in NumPy                median us      us/J")
    costs = {}
    for name, way in ways.items():
        assert np.allclose(way(particles), known, rtol=1e-12, atol=0), name
        costs[name], _, _ = seconds(400, lambda: way(particles))
        print(f"  {name:<38} {costs[name] * 1e6:10.1f} {costs[name] * 1e6 / PARTICLES:9.2f}")
    fastest = min(costs, key=costs.get)
    value, gradient = contracted.with_gradient(particles[0])
    assert abs(value - known[0]) < 1e-12 * value
    step = np.array([1e-5, 0, 0, 0])
    slope = (contracted.by_columns(particles[:1] + step) - contracted.by_columns(particles[:1] - step))[0] / 2e-5
    assert abs(gradient[0] - slope) < 1e-6 * value

    def ten(search):
        return lambda: min(float(np.min(search(seed))) for seed in range(RUNS))

    before = ours(program)
    rows = []
    for name, repeats, call in [
        ("NumPy, 50 particles stacked, assembled", 5, ten(lambda seed: swarm(assembled, seed))),
        (f"NumPy, 50 particles stacked, {fastest}", 9, ten(lambda seed: swarm(ways[fastest], seed))),
        ("the same, all ten swarms side by side", 9, lambda: swarm(ways[fastest], 0, RUNS).min()),
        ("pyswarms GlobalBestPSO on the same", 5, ten(lambda seed: by_pyswarms(ways[fastest], seed))),
    ]:
        median, least, minimum = seconds(repeats, call)
        check(name, minimum)
        rows.append((name, median, least, minimum))
    polish_median, polish_least, found = seconds(15, lambda: descents(contracted.with_gradient))
    check("L-BFGS-B", max(result.fun for result in found))
    after = ours(program)

    mean = lambda key: 0.5 * (float(before[key]) + float(after[key]))
    check("ours", float(after["search-minimum"]))
    width = max(len(row[0]) for row in rows)

    def table(title, key, last, rows):
        least = lambda label: min(float(run[f"{key}-{label}-least"]) for run in (before, after))
        one = mean(f"{key}-one-thread"), least("one-thread")
        print(f"\n{title:<{width}}   median ms    ours x    least ms    ours x   {last}")
        rows = list(rows)
        for label in ("one-thread", "all-threads"):
            name = f"ours ({after['path']}), {after['threads-' + label]} thread(s)"
            rows.append((name, mean(f"{key}-{label}"), least(label), ours_last[key]))
        for name, median, shortest, shown in rows:
            print(
                f"{name:<{width}} {median * 1e3:11.3f} {median / one[0]:9.2f} {shortest * 1e3:11.3f}"
                f" {shortest / one[1]:9.2f}   {shown}"
            )

    ours_last = {"search": f"{float(after['search-minimum']):.10f}", "ten-starts": after["ten-starts-evaluations"]}
    table("ten runs of 50 x 100", "search", "minimum found", [row[:3] + (f"{row[3]:.10f}",) for row in rows])
    evaluations = sum(result.nfev for result in found)
    descent = ("scipy L-BFGS-B, contracted tables", polish_median, polish_least, evaluations)
    table("ten descents with gradients", "ten-starts", "evaluations", [descent])
    first, second = sorted(float(run["search-one-thread"]) for run in (before, after))
    if second > 1.3 * first:
        print("\nours moved by more than 30 % between the two sittings: the machine was busy, measure again")


if __name__ == "__main__":
    main()
