# %% [markdown]
# # A canopy, from Rhino to STEP
# Four bent edges, drawn in any order and direction, come from a 3DM file; the film between them goes to a STEP file that holds its
# patches exactly. Needs the extra: `pip install 'plateau_patches[rhino]'`.

# %%
import rhino3dm

import plateau_patches as pp

# %% [markdown]
# The drawing, made here so that the example stands by itself: two high points, two low ones, edges that sag inwards. Metres.

# %%
high, low = 4.0, 1.0
corners = [(0.0, 0.0, high), (9.0, 0.0, low), (9.0, 7.0, high), (0.0, 7.0, low)]
middles = [(4.5, 0.8, 2.2), (8.2, 3.5, 2.2), (4.5, 6.2, 2.2), (0.8, 3.5, 2.2)]
drawing = rhino3dm.File3dm()
for k in (2, 0, 3, 1):
    points = [rhino3dm.Point3d(*p) for p in (corners[k], middles[k], corners[(k + 1) % 4])]
    if k == 3:
        points.reverse()
    drawing.Objects.AddCurve(rhino3dm.Curve.CreateControlPointCurve(points, 2))
drawing.Write("canopy.3dm", 7)

# %% [markdown]
# In: the curves as they are, chained by their ends. The film is of least area, so it is what a soap film, or a membrane of
# uniform stress, would be.

# %%
edges = pp.from_file("canopy.3dm")
canopy = pp.fill(edges, degree=8, name="canopy")
print(len(edges), "edges;", canopy, *canopy.warnings)
print(f"{canopy.area:.3f} m² of cloth, |H| at most {canopy.figures['mean_curvature']['max_abs']:.4f} /m")

# %% [markdown]
# Out: STEP for the office, 3DM for the drawing it came from, a mesh for a picture.

# %%
print(canopy.save("canopy.step"))
print(canopy.save("canopy-filled.3dm"))
canopy.save("canopy.glb")
