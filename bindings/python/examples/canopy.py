# ---
# jupyter:
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # A canopy, from Rhino to STEP
# The edges of a canopy, two cables, a polyline and an arc, come from a 3DM file in any order and direction; the film between them goes
# to a STEP file that holds its patches exactly. Needs the extra: `pip install 'plateau_patches[rhino]'`.

# %%
import rhino3dm

import plateau_patches as pp

# %% [markdown]
# The drawing, made here so that the example stands by itself: two high points, two low ones, metres. Two edges are cables that sag, one
# is a beam with a joint, one is an arch; there is a construction line on a layer that is switched off.

# %%
a, b, c, d = (rhino3dm.Point3d(*p) for p in ((0, 0, 4), (9, 0, 1), (9, 7, 4), (0, 7, 1)))


def cable(start, middle, end):
    points = [start, rhino3dm.Point3d(*middle), end]
    return rhino3dm.Curve.CreateControlPointCurve(points, 2)


drawing = rhino3dm.File3dm()
drawing.Settings.ModelUnitSystem = rhino3dm.UnitSystem.Meters
drawing.Objects.AddCurve(cable(c, (4.5, 6.2, 2.2), d))
drawing.Objects.AddArc(rhino3dm.Arc(a, rhino3dm.Point3d(4.5, -0.5, 3.5), b))
drawing.Objects.AddPolyline([c, rhino3dm.Point3d(9.3, 3.5, 3.0), b])
drawing.Objects.AddCurve(cable(a, (0.8, 3.5, 2.2), d))
layer = rhino3dm.Layer()
layer.Name, layer.Visible = "construction", False
attributes = rhino3dm.ObjectAttributes()
attributes.LayerIndex = drawing.Layers.Add(layer)
drawing.Objects.AddCurve(rhino3dm.LineCurve(a, c), attributes)
drawing.Write("canopy.3dm", 7)

# %% [markdown]
# In: the curves as they are, chained by their ends. The film is of least area, so it is what a soap film, or a membrane of
# uniform stress, would be.

# %%
edges = pp.from_file("canopy.3dm")
canopy = pp.fill(edges, degree=8, name="canopy")
print(len(edges), "edges;", *edges.notes)
print(canopy, *canopy.warnings, sep="\n")
print(f"{canopy.area:.3f} m² of cloth, |H| at most {canopy.figures['mean_curvature']['max_abs']:.4f} /m")

# %% [markdown]
# Out: STEP for the office, 3DM for the drawing it came from (in a group, whose surfaces Rhino joins), a mesh for a picture.

# %%
print(canopy.save("canopy.step"))
print(canopy.save("canopy-filled.3dm"))
canopy.save("canopy.glb")
