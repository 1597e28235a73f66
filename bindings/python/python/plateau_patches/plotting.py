"""Surfaces in other people's plots."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from .errors import BoundaryError

if TYPE_CHECKING:
    from .surface import Surface


def plot(surface: Surface, ax: Any, n: int, options: dict[str, Any]) -> Any:
    """As :meth:`Surface.plot`."""
    if ax is None:
        try:
            pyplot = importlib.import_module("matplotlib.pyplot")
        except ImportError:
            return _by_pyvista(surface, n, options)
        ax = pyplot.figure().add_subplot(projection="3d")
    if not hasattr(ax, "plot_trisurf"):
        raise BoundaryError('the axes are those of a plane: make them with projection="3d"')
    mesh = surface.mesh(n)
    x, y, z = mesh.vertices.T
    ax.plot_trisurf(x, y, z, triangles=mesh.faces, **{"linewidth": 0.1, **options})
    ax.set_box_aspect((mesh.vertices.max(axis=0) - mesh.vertices.min(axis=0)).clip(1e-3))
    ax.set_title(f"{surface.name}: area {surface.area:.7g}")
    return ax


def _by_pyvista(surface: Surface, n: int, options: dict[str, Any]) -> Any:
    try:
        pyvista = importlib.import_module("pyvista")
    except ImportError:
        raise ImportError("neither matplotlib nor pyvista is installed: pip install matplotlib") from None
    plotter = pyvista.Plotter()
    plotter.add_mesh(surface.to_pyvista(n), **options)
    plotter.show()
    return plotter
