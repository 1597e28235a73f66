"""Least areas over frames that no single patch spans, beside two independent programs, in one sitting.

    films.py PATH-OF-film_time [PATH-OF-evolver]

The frames: the hexagon of six edges of a cube, the catenoid between two rings, the film of the twelve edges of a cube, and the saddle
frame z = x^2 - y^2 over [-1, 1]^2. Their areas are known: closed forms, and for the cube film the best known digits.

- `film_time` (cargo build --release -p plateau-benches --example film_time) prints, for each frame and degree, the area and the
  time inside the process, without reading or writing files.
- The Surface Evolver (Debian package `evolver`) moves the vertices of quadratic facets by Newton's method; its time is the whole process.
- NGSolve (PyPI, benches/peer/requirements.txt) solves for a graph of order 4 or 8 by Newton's method; the time is the solve, without
  imports and meshing. Only where the surface is a graph over a plane.

For every row of ours the cheapest run of each peer that is at least as accurate is looked for, and the ratio of the times printed.
"""

import math
import pathlib
import subprocess
import sys
import tempfile
import time


def elliptic_k(m):
    """The complete elliptic integral K of parameter m, by the arithmetic-geometric mean."""
    a, b = 1.0, math.sqrt(1 - m)
    while abs(a - b) > 1e-15 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return math.pi / (2 * a)


def catenoid(half):
    """The area between circles of radius 1 at distance 2 * half: c cosh(half / c) = 1 with the larger c."""
    low, high = half / 1.19967864, 1.0
    for _ in range(200):
        c = (low + high) / 2
        low, high = (c, high) if c * math.cosh(half / c) < 1 else (low, c)
    return math.pi * c * (2 * half + c * math.sinh(2 * half / c))


HEXAGON = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1), (0, 0, 1)]
EXACT = {
    "hexagon": 1.5 * elliptic_k(0.75) / elliptic_k(0.25),
    "catenoid": catenoid(0.3),
    "saddle": 7.383505602602,
    "cube film": 4.2395631,
}
LEVELS = {"hexagon": 6, "catenoid": 5, "saddle": 6, "cube film": 5}


def loop_file(corners):
    """A polygon as one face, for the Surface Evolver."""
    n = len(corners)
    lines = ["vertices"] + [f"{k} {x} {y} {z} fixed" for k, (x, y, z) in enumerate(corners, 1)]
    lines += ["edges"] + [f"{k} {k} {k % n + 1} fixed" for k in range(1, n + 1)]
    return lines + ["faces", "1 " + " ".join(str(k) for k in range(1, n + 1))]


def catenoid_file(n=6):
    """Two rings of n vertices each, held on their circles by boundaries with a parameter, and n quadrilaterals."""
    lines = ["parameter half = 0.3"]
    for ring, z in ((1, "half"), (2, "-half")):
        lines += [f"boundary {ring} parameters 1", "x1: cos(p1)", "x2: sin(p1)", f"x3: {z}"]
    lines += ["vertices"]
    for ring in (1, 2):
        lines += [f"{(ring - 1) * n + k + 1} {2 * math.pi * k / n} boundary {ring} fixed" for k in range(n)]
    lines += ["edges"]
    for ring in (1, 2):
        base = (ring - 1) * n
        lines += [f"{base + k + 1} {base + k + 1} {base + (k + 1) % n + 1} boundary {ring} fixed" for k in range(n)]
    lines += [f"{2 * n + k + 1} {k + 1} {n + k + 1}" for k in range(n)]
    lines += ["faces"]
    lines += [f"{k + 1} {k + 1} {2 * n + (k + 1) % n + 1} -{n + k + 1} -{2 * n + k + 1}" for k in range(n)]
    return lines


def cube_file():
    """The film of the cube's edges: a square in the middle, from which films run to the twelve edges."""
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    inner = [(0.45 if x == 0 else 0.55, 0.45 if y == 0 else 0.55, 0.5) for y in (0, 1) for x in (0, 1)]
    lines = ["vertices"] + [f"{k} {x} {y} {z} fixed" for k, (x, y, z) in enumerate(corners, 1)]
    lines += [f"{9 + k} {x} {y} {z}" for k, (x, y, z) in enumerate(inner)]
    edges, faces = {}, []

    def edge(a, b, fixed=False):
        if (b, a) in edges:
            return -edges[b, a][0]
        if (a, b) not in edges:
            edges[a, b] = (len(edges) + 1, fixed)
        return edges[a, b][0]

    def face(*vertices):
        faces.append(" ".join(str(edge(a, b)) for a, b in zip(vertices, vertices[1:] + vertices[:1])))

    for a in range(8):
        for bit in (1, 2, 4):
            if not a & bit:
                edge(a + 1, (a | bit) + 1, True)
    inner_of = lambda corner: 9 + (corner & 3)
    face(9, 10, 12, 11)
    for a in range(8):
        for bit in (1, 2):
            if not a & bit:
                face(a + 1, (a | bit) + 1, inner_of(a | bit), inner_of(a))
    for a in range(4):
        face(a + 1, a + 5, inner_of(a))
    lines += ["edges"] + [f"{k} {a} {b}" + (" fixed" if fixed else "") for (a, b), (k, fixed) in edges.items()]
    return lines + ["faces"] + [f"{k} {face}" for k, face in enumerate(faces, 1)]


def by_evolver(program, lines, levels):
    """Area, unknowns and seconds of the whole process, for runs that end at each level of refinement."""
    rows = []
    for last in range(1, levels):
        steps = "r; g 5; u; V; u; hessian_seek; " * last
        text = "\n".join([*lines, "read", f"{steps} M 2; hessian_seek; hessian_seek; hessian; hessian;", 'printf "AREA %d %.15g\\n", vertex_count, total_area;', "q", "q", ""])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "frame.fe"
            path.write_text(text)
            start = time.perf_counter()
            run = subprocess.run([program, path], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
            seconds = time.perf_counter() - start
        found = [line.split() for line in run.stdout.splitlines() if line.startswith("AREA")]
        if not found:
            sys.exit(f"{program} did not finish:\n{run.stdout[-1500:]}{run.stderr}")
        rows.append((float(found[0][2]), 3 * int(found[0][1]), seconds))
    return rows


def by_ngsolve(frame):
    """Area, unknowns and seconds of the solve as a graph, for meshes and orders from coarse to fine."""
    import ngsolve as ng
    from netgen.geom2d import SplineGeometry

    ng.SetNumThreads(1) if hasattr(ng, "SetNumThreads") else None
    geometry = SplineGeometry()
    if frame == "saddle":
        geometry.AddRectangle((-1, -1), (1, 1), bc="rim")
        height, scale = ng.x * ng.x - ng.y * ng.y, 1.0
    else:
        # Over the plane perpendicular to (1, 1, 1) the hexagon is regular, its corners at heights that alternate.
        radius, size = math.sqrt(2 / 3), math.sqrt(3)
        corners = [geometry.AppendPoint(radius * math.cos(k * math.pi / 3), radius * math.sin(k * math.pi / 3)) for k in range(6)]
        for k in range(6):
            geometry.Append(["line", corners[k], corners[(k + 1) % 6]], bc="rim")
        rise = [0.0, 1 / size]
        angle = ng.atan2(ng.y, ng.x)
        # Height along a side is linear; as a function of the point on the rim it is linear in the distance from a corner.
        height = sum(
            ng.IfPos(-ng.cos(angle - (k + 0.5) * math.pi / 3) + math.cos(math.pi / 6), 0.0, 1.0)
            * (rise[k % 2] + (rise[(k + 1) % 2] - rise[k % 2])
               * ng.sqrt((ng.x - radius * math.cos(k * math.pi / 3)) ** 2 + (ng.y - radius * math.sin(k * math.pi / 3)) ** 2) / radius)
            for k in range(6)
        )
    rows = []
    for order in (4, 8):
        for size in (2.0, 1.0, 0.5, 0.25, 0.125):
            mesh = ng.Mesh(geometry.GenerateMesh(maxh=size))
            space = ng.H1(mesh, order=order, dirichlet="rim")
            u = space.TrialFunction()
            energy = ng.BilinearForm(space, symmetric=True, condense=False)
            energy += ng.Variation(ng.sqrt(1 + ng.InnerProduct(ng.grad(u), ng.grad(u))) * ng.dx(bonus_intorder=order))
            graph = ng.GridFunction(space)
            graph.Set(height, ng.BND)
            start = time.perf_counter()
            residual, step = graph.vec.CreateVector(), graph.vec.CreateVector()
            area = energy.Energy(graph.vec)
            for _ in range(30):
                energy.AssembleLinearization(graph.vec)
                energy.Apply(graph.vec, residual)
                step.data = energy.mat.Inverse(space.FreeDofs(), "sparsecholesky") * residual
                length, base = 1.0, graph.vec.Copy()
                while True:
                    graph.vec.data = base - length * step
                    reached = energy.Energy(graph.vec)
                    if reached <= area * (1 + 1e-14) or length < 1e-3:
                        break
                    length /= 2
                done, area = abs(area - reached) <= 1e-14 * area, reached
                if done:
                    break
            rows.append((area, sum(space.FreeDofs()), time.perf_counter() - start))
    return rows


def cheapest(rows, exact, error):
    """The cheapest run whose area is at least as close; none if no run is."""
    close = [row for row in rows if abs(row[0] / exact - 1) <= error]
    return min(close, key=lambda row: row[2], default=None)


def main():
    ours, evolver = (sys.argv[1:] + ["target/release/examples/film_time", "evolver"][len(sys.argv) - 1 :])[:2]
    printed = subprocess.run([ours], capture_output=True, text=True, check=True).stdout
    frames = {"hexagon": loop_file(HEXAGON), "catenoid": catenoid_file(), "cube film": cube_file()}
    peers = {name: {"Evolver": by_evolver(evolver, lines, LEVELS[name])} for name, lines in frames.items()}
    peers["saddle"] = {}
    for name in ("hexagon", "saddle"):
        try:
            peers[name]["NGSolve"] = by_ngsolve(name)
        except ImportError:
            print("left out: NGSolve is not installed")
    for name, programs in peers.items():
        for program, rows in programs.items():
            for area, unknowns, seconds in rows:
                print(f"{name:<12}{program:<10}{unknowns:>8}{area:>20.13f}{area / EXACT[name] - 1:>10.1e}{1e3 * seconds:>10.1f} ms")
    print()
    for line in printed.splitlines():
        name, degree, area, seconds = line.rsplit(maxsplit=3)
        error = abs(float(area) / EXACT[name] - 1)
        parts = [f"{name:<12}degree {degree:>2}{float(area):>20.13f}{error:>10.1e}{1e3 * float(seconds):>10.2f} ms"]
        for program, rows in peers[name].items():
            peer = cheapest(rows, EXACT[name], max(error, 1e-15))
            parts.append(f"{program}: " + (f"{peer[2] / float(seconds):.0f} x" if peer else "never as close"))
        print("   ".join(parts))


if __name__ == "__main__":
    main()
