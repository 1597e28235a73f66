"""Least areas over five skew quadrilaterals by the Surface Evolver, an independent program, beside ours.

    evolver.py [PATH-OF-plateau] [PATH-OF-evolver]

The Surface Evolver (Debian package `evolver`; Brakke, 1992) moves the vertices of a triangulation until its area is
least, by Newton's method here. Its areas fall to the least area of the boundary as the facets shrink, by a factor 4 of the
distance at every refinement; the limit is extrapolated from the last three levels (Richardson, twice), and the change
by the second step says how far to trust it. Ours is the patch of least area of degree 8 over the same sides, which are
straight and therefore exact. A polynomial patch cannot have less area than the minimal surface, nor should it have
much more. The run fails unless every area of ours lies between the limit - 1e-6 and the limit + 1e-3.

Python's standard library only. A few seconds.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

DEGREE = 8
LEVELS = 6
BELOW, ABOVE = 1e-6, 1e-3

# Four corners each, in turn round the boundary.
BOUNDARIES = {
    "skew square": [(0, 0, 0), (1, 0, 1), (1, 1, 0), (0, 1, 1)],
    "edges of a tetrahedron": [(1, 1, 1), (1, -1, -1), (-1, -1, 1), (-1, 1, -1)],
    "lifted trapezium": [(0, 0, 0), (3, 0, 0), (2, 1, 1), (0, 1, 0)],
    "kite": [(0, 0, 0), (2, -0.5, 0.75), (3, 0, 0), (2, 1, -0.5)],
    "flat parallelogram": [(0, 0, 0), (2, 0, 0.25), (2.5, 1, 0), (0.5, 1, 0.125)],
}


def datafile(corners):
    """The quadrilateral for the Surface Evolver, with the commands that refine and minimise it."""
    lines = ["vertices"]
    lines += [f"{k} {x} {y} {z} fixed" for k, (x, y, z) in enumerate(corners, 1)]
    lines += ["edges"] + [f"{k} {k} {k % 4 + 1} fixed" for k in range(1, 5)]
    lines += ["faces", "1 1 2 3 4", "read"]
    # r refines, g descends, u flips edges, V averages vertices; then Newton's method.
    for level in range(LEVELS):
        lines.append("r; g 5; u; V; u; hessian_seek; hessian; hessian; hessian;")
        lines.append(f'printf "LEVEL {level} %d %.15g\\n", facet_count, total_area;')
    return "\n".join(lines + ["q", "q", ""])


def by_evolver(program, corners, folder):
    """The limit of the areas, its uncertainty, and the last level: facets and area."""
    path = folder / "boundary.fe"
    path.write_text(datafile(corners))
    run = subprocess.run([program, path], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
    levels = [line.split() for line in run.stdout.splitlines() if line.startswith("LEVEL")]
    if len(levels) != LEVELS:
        sys.exit(f"{program} did not finish:\n{run.stdout[-2000:]}{run.stderr}")
    areas = [float(level[3]) for level in levels]
    first = [fine + (fine - coarse) / 3 for coarse, fine in zip(areas[-3:], areas[-2:])]
    limit = first[1] + (first[1] - first[0]) / 15
    return limit, abs(limit - first[1]), int(levels[-1][2]), areas[-1]


def by_plateau(program, corners, folder):
    """The least area of degree 8 and the bound of its error."""
    a, b, c, d = (list(corner) for corner in corners)
    path = folder / "boundary.toml"
    path.write_text(
        f"""title = "boundary"

[boundary]
u0 = {[a, d]}
u1 = {[b, c]}
v0 = {[a, b]}
v1 = {[d, c]}

[[method]]
name = "least area"
energy = "area"
raise = {DEGREE - 1}

[output]
pictures = false
"""
    )
    subprocess.run([program, "run", "--quiet", "--out", folder, path], check=True, stdout=subprocess.DEVNULL)
    result = json.loads((folder / "boundary" / "result.json").read_text())
    [method] = result["methods"]
    return method["area"], method["area_error"]


def main():
    plateau, evolver = (sys.argv[1:] + ["target/release/plateau", "evolver"][len(sys.argv) - 1 :])[:2]
    start, failed = time.monotonic(), False
    print(f"{'boundary':<24}{'facets':>8}{'evolver':>16}{'limit':>16}{'+-':>9}{'ours':>16}{'+-':>9}{'ours - limit':>14}")
    for name, corners in BOUNDARIES.items():
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            limit, doubt, facets, last = by_evolver(evolver, corners, folder)
            ours, error = by_plateau(plateau, corners, folder)
        difference = ours - limit
        holds = -BELOW <= difference <= ABOVE
        failed |= not holds
        print(
            f"{name:<24}{facets:>8}{last:>16.10f}{limit:>16.10f}{doubt:>9.0e}{ours:>16.10f}{error:>9.0e}{difference:>14.1e}"
            + ("" if holds else "  FAILS")
        )
    print(f"{time.monotonic() - start:.1f} s")
    sys.exit(failed)


if __name__ == "__main__":
    main()
