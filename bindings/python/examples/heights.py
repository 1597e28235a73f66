# ---
# jupyter:
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # A study of heights
# Two opposite corners of a square frame are lifted. How does the least area grow, and how stable is the film?

# %%
import numpy as np
import pandas as pd
from matplotlib import pyplot as plt

import plateau_patches as pp

# %%
rows = []
for height in np.linspace(0.0, 3.0, 7):
    film = pp.fill([[0, 0, 0], [1, 0, height], [1, 1, 0], [0, 1, height]], degree=8)
    rows.append(
        {
            "height": height,
            "area": film.area,
            "error": film.area_error,
            "second variation": film.second_variation,
            "largest |H|": film.figures["mean_curvature"].get("max_abs"),
        }
    )
study = pd.DataFrame(rows).set_index("height")
study

# %% [markdown]
# A flat frame is a unit square. High up, the film is nearly two triangles, whose edges are as long as the frame is high.

# %%
assert abs(study["area"].iloc[0] - 1.0) < 1e-9
assert study["area"].is_monotonic_increasing and (study["second variation"] > 0).all()
figure, axes = plt.subplots()
study["area"].plot(ax=axes, marker="o", ylabel="least area", grid=True)
figure.savefig("heights.png")
plt.close(figure)
