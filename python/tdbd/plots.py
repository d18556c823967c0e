"""Simple plots with matplotlib. reports/draw.py draws more detailed ones of a result folder."""

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

    from tdbd.surfaces import Surface


def _figure(columns: int) -> "Figure":
    """Returns a figure that is independent of pyplot: no window opens."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.2 * columns, 4.4), layout="constrained")
    FigureCanvasAgg(figure)
    figure.subplots(1, columns)
    return figure


def bottom_hole(rock: "Surface", history: "xarray.Dataset", title: str) -> "Figure":
    """Plots the hole from above (x to the right, y down) and the removed rock over revolutions."""
    figure = _figure(2)
    hole, removed = figure.axes
    x, y, z = 1e3 * rock.vertices.T
    colours = hole.tripcolor(x, y, rock.faces, z, shading="gouraud", cmap="viridis_r")
    figure.colorbar(colours, ax=hole, label="depth, mm")
    hole.set(aspect="equal", xlabel="x, mm", ylabel="y, mm", title=title)
    hole.invert_yaxis()
    turns = np.asarray(history["rotation_angle"]) / (2 * np.pi)
    removed.plot(turns, 1e6 * np.asarray(history["removed_volume_total"]))
    removed.set(xlabel="revolutions", ylabel="rock removed, cm$^3$")
    return figure


def axis_path(history: "xarray.Dataset", summary: dict[str, Any]) -> "Figure":
    """Plots the path of the third body axis from above and the drift of the energy."""
    figure = _figure(2)
    path, energy = figure.axes
    axis = np.asarray(history["axis_W"])
    path.plot(axis[:, 0], axis[:, 1], linewidth=0.8)
    path.set(aspect="equal", xlabel="x of the axis", ylabel="y of the axis", title=summary["title"])
    drift = np.asarray(history["total_energy"]) - summary["energy_start"]
    energy.plot(np.asarray(history["time"]), drift / summary["energy_scale"], linewidth=0.8)
    energy.set(xlabel="time, s", ylabel="change of the energy over its scale")
    return figure


def errors(sizes: np.ndarray, errors: dict[str, np.ndarray], data: dict[str, Any]) -> "Figure":
    """Plots relative errors (`errors`, SI) over `sizes`; `data`: convergence.json."""
    figure = _figure(1)
    axes = figure.axes[0]
    for variable, values in errors.items():
        found = data["variables"][variable]
        order = "no order" if found["order"] is None else f"order {found['order']:.2f}"
        axes.loglog(sizes[:len(values)], values / found["scale"], "o-", label=f"{variable}: {order}")
    axes.set(xlabel=data["over"], ylabel=f"difference to the {data['against']} over the scale")
    axes.legend(fontsize=7)
    return figure
