"""certificates.py PLATEAU: certificate.py confirms the lower bounds that PLATEAU proves on 20 frames, and refuses 5 forged ones."""

import copy
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from certificate import SURFACES, Refused, verify


def sides(corners, bend):
    """Quadratic sides over a quadrilateral (P00, Pm0, Pmn, P0n); `bend` moves the middle of each from the straight line."""
    a, b, c, d = corners

    def side(p, q, by):
        return [p, [0.5 * (s + t) + m for s, t, m in zip(p, q, by)], q]

    return {"u0": side(a, d, bend[0]), "u1": side(b, c, bend[1]), "v0": side(a, b, bend[2]), "v1": side(d, c, bend[3])}


def frames():
    """20 frames with the number of degrees to raise them by."""
    flat = [[0.0, 0.0, 0.0]] * 4
    skew = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 0.0]]
    square = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]]
    saddle = [[0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, -1.0]]
    for raised in 0, 2, 4:
        yield sides(skew, flat), raised
        yield sides(square, saddle), raised
    # A side that dips into the square: only graphs are bounded.
    yield sides(square, saddle[:2] + [[0.0, 0.3, -1.0], [0.0, 0.0, -1.0]]), 2
    random.seed(17)

    def of(reach):
        return random.uniform(-reach, reach)

    for _ in range(13):
        corners = [[x + of(0.25), y + of(0.25), of(0.8)] for x, y, _ in square]
        yield sides(corners, [[0.0, 0.0, of(0.8)] for _ in range(4)]), 2


def results(plateau, folder):
    for k, (boundary, raised) in enumerate(frames()):
        lines = [f"{name} = {points}" for name, points in boundary.items()]
        method = f'[[method]]\nname = "least"\nenergy = "area"\nraise = {raised}\nbound = true\n'
        file = Path(folder, f"frame-{k}.toml")
        file.write_text("\n".join([f'title = "frame {k}"', "[boundary]", *lines, method]))
        subprocess.run([plateau, "run", file, "--out", folder], check=True, stdout=subprocess.DEVNULL)
        yield json.loads(Path(folder, file.stem, "result.json").read_text())["methods"][0]


def forgeries(methods):
    """Certificates that prove nothing, or not what they say."""
    sound, graph = methods[2], next(m for m in methods if m["lower_bound_proof"]["holds_for"] != SURFACES)

    def forged(method, change):
        method = copy.deepcopy(method)
        change(method, method["lower_bound_proof"])
        return method

    def higher(method, _):
        method["lower_bound"] *= 1 + 1e-6

    def steep(_, proof):
        for face in proof["faces"]:
            face["potential"] = [[1.5 * c for c in row] for row in face["potential"]]

    def stretched(method, proof):
        proof["plane"]["axes"] = [[1.01 * c for c in axis] for axis in proof["plane"]["axes"]]
        method["lower_bound"] *= 1.01

    def larger_rim(method, proof):
        proof["faces"][0]["net"][0][0][2] += 0.5
        method["lower_bound"] -= 0.1

    def all_surfaces(_, proof):
        proof["holds_for"] = SURFACES

    yield "a bound above what is proved", forged(sound, higher)
    yield "a potential half as steep again", forged(sound, steep)
    yield "axes that are too long", forged(sound, stretched)
    yield "another rim", forged(sound, larger_rim)
    yield "all surfaces, where only graphs are bounded", forged(graph, all_surfaces)


def main(plateau):
    with tempfile.TemporaryDirectory() as folder:
        methods = list(results(plateau, folder))
    for k, method in enumerate(methods):
        verify(method)
        gap = method["area"] - method["lower_bound"]
        print(f"confirmed: frame {k}: {method['lower_bound']!r}, {gap:.1e} below the area found; {method['lower_bound_proof']['holds_for']}")
    for what, method in forgeries(methods):
        try:
            verify(method)
        except Refused as why:
            print(f"refused: {what}: {why}")
        else:
            raise SystemExit(f"a forged certificate is confirmed: {what}")
    print(f"{len(methods)} certificates confirmed, 5 forged ones refused")


if __name__ == "__main__":
    main(sys.argv[1])
