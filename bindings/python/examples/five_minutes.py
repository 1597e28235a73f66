# ---
# jupyter:
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # Five minutes
# Curves in, the surface of least area over them out, with figures whose errors are known. With jupytext this file opens as a
# notebook; it runs as a script as well.

# %%
import numpy as np

import plateau_patches as pp

# %% [markdown]
# Four sides by their control points, shape (n + 1, 3). `u0` and `u1` run in the sense of v, `v0` and `v1` in the sense of u, and every
# corner stands in two of them.

# %%
u0, u1 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]], [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
v0, v1 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]], [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]
patch = pp.least_area(u0, u1, v0, v1, degree=8)
patch

# %% [markdown]
# The figures say how good it is: the error of the area, the curvature that is left (a minimal surface has none), whether the
# surface is a stable minimum. What cannot be trusted is among the warnings.

# %%
curvature = patch.figures["mean_curvature"]
print(f"area {patch.area:.9f} ± {patch.area_error:.0e}, |H| at most {curvature['max_abs']:.3f}")
print(f"second variation {patch.second_variation:.3f}, warnings: {patch.warnings or 'none'}")

# %% [markdown]
# Parameters broadcast; meshes are arrays.

# %%
t = np.linspace(0.0, 1.0, 50)
points = patch.evaluate(t[:, None], t)
mesh = patch.mesh(48)
print(points.shape, mesh.vertices.shape, mesh.faces.shape)

# %% [markdown]
# Any closed loop will do: here 200 points around a wave. It is cut into patches that share their edges; the kink says how nearly
# smooth they meet.

# %%
t = np.linspace(0.0, 2.0 * np.pi, 200, endpoint=False)
loop = np.stack([np.cos(t), np.sin(t), 0.3 * np.cos(3.0 * t)], axis=1)
film = pp.fill(loop)
print(film, f"kink at most {np.degrees(film.kink.max):.3f}°")

# %% [markdown]
# Files by their extension. STEP holds the patches themselves, not a mesh.

# %%
print(film.save("film.step"))
film.save("film.glb")

# %% [markdown]
# What the command runs, Python runs: a file, its text or a dict. The results are the same bits.

# %%
results = pp.run(
    {
        "title": "Two energies",
        "boundary": {"u0": u0, "u1": u1, "v0": v0, "v1": v1},
        "method": [
            {"name": "Dirichlet", "energy": "dirichlet", "raise": 4},
            {"name": "Least area", "energy": "area", "raise": 4},
        ],
    }
)
print(results.table(100))
