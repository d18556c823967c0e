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


def _hole(rock: "Surface", history: "xarray.Dataset", gage_radius: float) -> tuple[np.ndarray, float, np.ndarray]:
    """Returns the centre and radius (m) of the hole, and which faces are inside it."""
    place = np.column_stack([np.asarray(history["position_x"]), np.asarray(history["position_y"])])
    centre = 0.5 * (place.min(axis=0) + place.max(axis=0))
    radius = gage_radius + np.max(np.hypot(*(place - centre).T))
    middle = rock.vertices[rock.faces][:, :, :2].mean(axis=1)
    return centre, radius, np.hypot(*(middle - centre).T) <= radius


def bottom_hole(rock: "Surface", history: "xarray.Dataset", summary: dict[str, Any]) -> "Figure":
    """Plots the hole from above (x to the right, y down) and the removed rock over revolutions.

    The rock outside the hole is left out, so that axes and colours span the hole alone.
    """
    figure = _figure(2)
    hole, removed = figure.axes
    centre, radius, inside = _hole(rock, history, summary["gage_radius_m"])
    faces = rock.faces[inside] if inside.any() else rock.faces
    x, y, z = 1e3 * rock.vertices.T
    used = np.unique(faces)
    bottom = z[used[np.hypot(*(rock.vertices[used, :2] - centre).T) < 0.98 * radius]]  # without the wall
    bottom = bottom if bottom.size else z[used]
    colours = hole.tripcolor(x, y, faces, z, shading="gouraud", cmap="viridis_r", vmin=bottom.min(), vmax=bottom.max())
    figure.colorbar(colours, ax=hole, label="depth, mm")
    (left, top), (right, low) = 1e3 * (centre - 1.03 * radius), 1e3 * (centre + 1.03 * radius)
    hole.set(aspect="equal", xlabel="x, mm", ylabel="y, mm", title=summary["title"], xlim=(left, right),
             ylim=(low, top))
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
