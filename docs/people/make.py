"""make.py PLATEAU: the files of docs/people.md, filled and drawn by its commands; fails if one of them does."""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent


def obj(lines, closed=False):
    """Polylines of an OBJ file, each a list of points."""
    text, first = "", 1
    for points in lines:
        text += "".join("v " + " ".join(f"{x:.6g}" for x in p) + "\n" for p in points)
        numbers = list(range(first, first + len(points))) + ([first] if closed else [])
        text += "l " + " ".join(map(str, numbers)) + "\n"
        first += len(points)
    return text


def circle(radius, z, count=48):
    angles = [2 * math.pi * k / count for k in range(count)]
    return [(radius * math.cos(a), radius * math.sin(a), z(a)) for a in angles]


def beams():
    return "x,y,z\n0,0,0\n4,0,1\n5,3,0\n2,5,2\n-1,3,0\n"


def hoop():
    return obj([circle(2.0, lambda a: 0.6 * math.cos(2 * a))], closed=True)


def rings():
    return obj([circle(1.0, lambda a: 0.0), circle(1.0, lambda a: 0.6)], closed=True)


def edges():
    """Four curved edges in no order and with different numbers of points, as drawn by hand."""
    corners = [(0, 0, 0), (3, 0, 0), (3, 2, 1), (0, 2, 0.5)]
    sides = []
    for k, (p, q) in enumerate(zip(corners, corners[1:] + corners[:1])):
        count = 9 + 6 * k
        at = [j / count for j in range(count + 1)]
        sides.append([[a + t * (b - a) for a, b in zip(p, q)] for t in at])
        for t, point in zip(at, sides[-1]):
            point[2] += (-1) ** k * 1.2 * t * (1 - t)
    return obj([sides[2], sides[0][::-1], sides[3], sides[1]])


def tent():
    """A square of cables with a mast in the middle: four panels that meet in it."""
    corners = [(0, 0, 0), (4, 0, 1), (4, 4, 0), (0, 4, 1)]
    top = (2, 2, 3)
    return obj([[a, b] for a, b in zip(corners, corners[1:] + corners[:1])] + [[a, top] for a in corners])


def dxf():
    """An arc and two lines of a drawing."""
    out = ["0", "SECTION", "2", "ENTITIES", "0", "ARC", "8", "0", "10", "1", "20", "0", "30", "0", "40", "1", "50", "180", "51", "360"]
    for (x, y, z), (a, b, c) in [((0, 0, 0), (1, 0.7, 0.5)), ((1, 0.7, 0.5), (2, 0, 0))]:
        out += ["0", "LINE", "8", "0", "10", x, "20", y, "30", z, "11", a, "21", b, "31", c]
    return "\n".join(map(str, out + ["0", "ENDSEC", "0", "EOF"])) + "\n"


FILES = {"beams.csv": beams, "hoop.obj": hoop, "rings.obj": rings, "edges.obj": edges, "tent.obj": tent, "arch.dxf": dxf}


def main(plateau):
    def call(*arguments):
        done = subprocess.run([plateau, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == 0, (arguments, done.stdout, done.stderr)
        return done.stdout

    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for name, content in FILES.items():
            path = HERE / name
            path.write_text(content())
            experiment = folder / f"{path.stem}.toml"
            print(f"plateau fill {name}")
            print(call("fill", path, "-o", folder / f"{path.stem}.step", "-o", experiment))
            call("run", experiment, "--out", folder)
            picture = (folder / path.stem / "surfaces.svg").read_bytes()
            (HERE / f"{path.stem}.svg").write_bytes(picture)


main(sys.argv[1])
