"""The lines that outside programs rely on, with nothing but the package and NumPy. Run by itself."""

import numpy as np

import plateau_patches as pp

u0, u1 = [[-1, -1, 0], [-1, 0, 2], [-1, 1, 0]], [[1, -1, 0], [1, 0, 2], [1, 1, 0]]
v0, v1 = [[-1, -1, 0], [0, -1, -2], [1, -1, 0]], [[-1, 1, 0], [0, 1, -2], [1, 1, 0]]
loop = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]])
u = v = np.linspace(0, 1, 5)
with open("experiment.toml", "w") as file:
    file.write(
        "title = 'A skew square'\n[boundary]\npolygon = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]\n"
        '[[method]]\nname = "Least area"\nenergy = "area"\ndegree = 6\n'
    )

patch = pp.least_area(u0, u1, v0, v1, degree=8)
film = pp.fill([loop], degree=6)
print(patch.area, patch.area_error, patch.net.shape, patch.evaluate(u, v).shape, len(patch.mesh(48)[0]))
print(film.faces, film.kink, film.save("x.step"))
result = pp.run("experiment.toml")
assert abs(result["Least area"].area - film.area) < 1e-12 and abs(patch.area - 7.3835056) < 1e-7
