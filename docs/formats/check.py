"""Reads exported files back with programs that are not ours.

    python check.py DIR...      every .obj .ply .stl .vtu .bezier.vtu .step file in folders written by `plateau run`

Meshes are compared with their OBJ file; STEP faces and Bézier cells with the net of result.json where that is a Bernstein patch, and with
the mesh (points on the patch, from the OBJ file) otherwise; OpenCASCADE checks their topology, gmsh measures their area, too, VTK that of cells. Prints one line a file; exit status 1 if one is not as it should be.
"""

import json
import math
import re
import sys
from pathlib import Path

import gmsh
import meshio
import numpy as np
import trimesh
import vtk
from OCP.BRep import BRep_Tool
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

SINGLE = 2.0**-23
EXACT = 1e-12


def size(points):
    return float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))


def read_obj(path):
    """Points, parameters and triangles, read by hand: the reference for all other files."""
    rows = {"v": [], "vt": [], "f": []}
    for line in path.read_text().splitlines():
        kind, *words = line.split()
        if kind in rows:
            rows[kind].append([w.split("/")[0] for w in words])
    return (np.array(rows["v"], float), np.array(rows["vt"], float), np.array(rows["f"], int) - 1)


def check_obj(path, mesh):
    read = trimesh.load(path, process=False, force="mesh")
    return np.array_equal(read.faces, mesh[2]) and np.abs(read.vertices - mesh[0]).max() < 1e-7 * size(mesh[0])


def check_ply(path, mesh):
    read = trimesh.load(path, process=False)
    data = read.metadata["_ply_raw"]["vertex"]["data"]
    points = np.column_stack([data[k] for k in "xyz"])
    parameters = np.column_stack([data[k] for k in "uv"])
    normals = np.column_stack([data[k] for k in ("nx", "ny", "nz")])
    same = np.array_equal(points, mesh[0]) and np.array_equal(parameters, mesh[1])
    same &= np.array_equal(read.faces, mesh[2])
    same &= np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-14
    return same and data["mean_curvature"].dtype == np.float64 and data["gauss_curvature"].dtype == np.float64


def check_stl(path, mesh):
    read = trimesh.load(path, process=False)
    corners = mesh[0][mesh[2]].reshape(-1, 3)
    found = read.triangles.reshape(-1, 3)
    return found.shape == corners.shape and np.abs(found - corners).max() <= SINGLE * np.abs(corners).max()


def check_vtu(path, mesh):
    read = meshio.read(path)
    cells = read.cells_dict["triangle"]
    same = np.array_equal(read.points, mesh[0]) and np.array_equal(cells, mesh[2])
    same &= np.array_equal(read.point_data["parameters"], mesh[1])
    ply = path.with_suffix(".ply")
    for name in ("mean_curvature", "gauss_curvature"):
        values = read.point_data[name]
        if ply.exists():
            raw = trimesh.load(ply, process=False).metadata["_ply_raw"]["vertex"]["data"][name]
            same &= np.array_equal(values.ravel(), np.ravel(raw), equal_nan=True)
    return same


class Cell:
    """A cell as VTK evaluates it."""

    def __init__(self, grid, number):
        self.cell = vtk.vtkGenericCell()
        grid.GetCell(number, self.cell)
        self.cell = self.cell.GetRepresentativeCell()
        self.count = self.cell.GetNumberOfPoints()

    def point(self, r, s):
        found, weights = [0.0] * 3, [0.0] * self.count
        self.cell.EvaluateLocation(vtk.reference(0), [r, s, 0.0], found, weights)
        return np.array(found)

    def area(self, rule):
        """By a rule of (r, s, weight), derivatives as differences of the fourth order: VTK's own are for quadrilaterals only."""
        step, total = 2e-4, 0.0

        def slope(along):
            one, two = along(step) - along(-step), along(2 * step) - along(-2 * step)
            return (8 * one - two) / (12 * step)

        for r, s, weight in rule:
            by_r, by_s = slope(lambda h: self.point(r + h, s)), slope(lambda h: self.point(r, s + h))
            total += weight * np.linalg.norm(np.cross(by_r, by_s))
        return total


def gauss(count, triangle):
    """A rule over the unit square; over the triangle r + s < 1 that of the square folded into it."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    nodes, weights = (nodes + 1) / 2, weights / 2
    square = [(r, s, a * b) for r, a in zip(nodes, weights) for s, b in zip(nodes, weights)]
    return [(r, s * (1 - r), w * (1 - r)) for r, s, w in square] if triangle else square


def check_cells(path, mesh, method):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    cells = [Cell(grid, k) for k in range(grid.GetNumberOfCells())]
    steps = np.linspace(0, 1, 23)
    entry = next(file for file in method["files"] if file["file"] == path.name)
    worst, points = 0.0, mesh[0]
    if "faces" in method or (method["patch"], method["basis"]) == ("tensor", "bernstein"):
        nets = [np.array(face["net"]) for face in method.get("faces", [method])]
        # A face may be turned over to lie on the side of its neighbours.
        for cell, net in zip(cells, nets, strict=True):
            turned = np.abs(cell.point(1, 0) - net[-1, 0]).max() > EXACT * size(points)
            for u in steps:
                for v in steps:
                    where = (v, u) if turned else (u, v)
                    worst = max(worst, float(np.linalg.norm(cell.point(*where) - bernstein(net, u, v))))
    elif method["patch"] == "triangle":
        for point, (u, v) in zip(points, mesh[1]):
            worst = max(worst, float(np.linalg.norm(cells[0].point(v, 1 - u - v) - point)))
    else:
        rows, cols = map(int, re.search(r"in (\d+) x (\d+) segments", entry["description"]).groups())
        low, high = mesh[1].min(axis=0), mesh[1].max(axis=0)
        for point, parameters in zip(points, mesh[1]):
            at = (parameters - low) / (high - low) * [rows, cols]
            i, j = np.minimum(at.astype(int), [rows - 1, cols - 1])
            worst = max(worst, float(np.linalg.norm(cells[i * cols + j].point(at[0] - i, at[1] - j) - point)))
    limit = entry.get("deviation", EXACT * size(points))
    degree = max(int(k) for k in np.ravel([grid.GetCellData().GetHigherOrderDegrees().GetTuple(k) for k in range(len(cells))]))
    rule = gauss(2 + degree if "deviation" in entry else 24, grid.GetCellType(0) == vtk.VTK_BEZIER_TRIANGLE)
    area, expected = sum(cell.area(rule) for cell in cells), method["area"]
    same = abs(area - expected) <= (1e-5 if "deviation" in entry else 1e-10) * expected
    note = f"{len(cells)} cells of degree {degree}, deviation {worst:.2e} of {limit:.2e} admitted, area {area:.12g}, ours {expected:.12g}"
    return worst <= limit and same, note


def step_faces(path):
    reader = STEPControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_RetDone:
        raise ValueError("OpenCASCADE cannot read it")
    reader.TransferRoots()
    shape = reader.OneShape()
    faces, explorer = [], TopExp_Explorer(shape, TopAbs_FACE)
    while explorer.More():
        faces.append(TopoDS.Face_s(explorer.Current()) if hasattr(TopoDS, "Face_s") else TopoDS.Face(explorer.Current()))
        explorer.Next()
    return shape, faces


def bernstein(net, u, v):
    """The Bernstein patch of a net at (u, v)."""
    def functions(n, t):
        return np.array([math.comb(n, k) * t**k * (1 - t) ** (n - k) for k in range(n + 1)])
    rows, cols = net.shape[:2]
    return np.einsum("i,ijk,j->k", functions(rows - 1, u), net, functions(cols - 1, v))


def square(parameters):
    """Parameters of a triangular patch on the square its face has."""
    u, v = parameters
    return 1 - u, (1 - v / (1 - u) if u < 1 else 0.0)


def check_step(path, mesh, method):
    shape, faces = step_faces(path)
    if len(faces) != 1 or not BRepCheck_Analyzer(shape).IsValid():
        return False, f"{len(faces)} faces, valid by BRepCheck: {BRepCheck_Analyzer(shape).IsValid()}"
    surface = BRep_Tool.Surface_s(faces[0])
    if type(surface).__name__ != "Geom_BSplineSurface":
        return False, type(surface).__name__
    kind = (method["patch"], method["basis"])
    points, parameters, triangles = mesh
    worst = 0.0
    for point, (u, v) in zip(points, parameters):
        s, t = square((u, v)) if kind[0] == "triangle" else (u, v)
        p = surface.Value(s, t)
        worst = max(worst, float(np.linalg.norm(point - [p.X(), p.Y(), p.Z()])))
    header = path.read_text(errors="replace").split("ENDSEC;")[0].replace("\n", "")
    stated = re.search(r"farther than\s+([0-9.e+-]+)", header)
    limit = float(stated.group(1)) if stated else EXACT * size(points)
    if kind == ("tensor", "bernstein"):
        net = np.array(method["net"])
        grid = np.linspace(0, 1, 23)
        for u in grid:
            for v in grid:
                p = surface.Value(u, v)
                worst = max(worst, float(np.linalg.norm(bernstein(net, u, v) - [p.X(), p.Y(), p.Z()])))
    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(faces[0], properties, 1e-9)
    area, expected = properties.Mass(), method.get("area")
    gmsh.clear()
    gmsh.model.occ.importShapes(str(path))
    gmsh.model.occ.synchronize()
    in_gmsh = [gmsh.model.occ.getMass(dimension, tag) for dimension, tag in gmsh.model.getEntities(2)]
    note = (
        f"degree ({surface.UDegree()}, {surface.VDegree()}), {surface.NbUPoles()} x {surface.NbVPoles()} control points, "
        f"deviation {worst:.2e} of {limit:.2e} admitted, area {area:.10g}, in gmsh {sum(in_gmsh):.10g}, ours {expected:.10g}"
    )
    areas = len(in_gmsh) == 1 and all(abs(a - expected) <= 1e-5 * expected for a in (area, in_gmsh[0]))
    return worst <= limit and areas, note


def file_name(name):
    return "-".join(re.findall(r"\w+", name.replace("_", " ").lower()))[:80] or "method"


def main(folders):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    sound = True
    for folder in map(Path, folders):
        methods = {file_name(m["name"]): m for m in json.loads((folder / "result.json").read_text())["methods"]}
        for stem, method in methods.items():
            reference = folder / f"{stem}.obj"
            if not reference.exists():
                continue
            mesh = read_obj(reference)
            for kind, check in (("obj", check_obj), ("ply", check_ply), ("stl", check_stl), ("vtu", check_vtu)):
                path = folder / f"{stem}.{kind}"
                if path.exists():
                    good = bool(check(path, mesh))
                    sound &= good
                    print(f"{path}: {'as written' if good else 'WRONG'}")
            for ending, check in (("step", check_step), ("bezier.vtu", check_cells)):
                path = folder / f"{stem}.{ending}"
                if path.exists():
                    good, note = check(path, mesh, method)
                    sound &= bool(good)
                    print(f"{path}: {'as written' if good else 'WRONG'}: {note}")
    return 0 if sound else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
