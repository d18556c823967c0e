"""Simple pictures by matplotlib; reports/draw.py draws finer ones of a result folder."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from tdbd.results import RotationResult, RunResult
    from tdbd.studies import Convergence


def _figure(columns: int) -> "Figure":
    """Without pyplot: no window, nothing that stays open."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.2 * columns, 4.4), layout="constrained")
    FigureCanvasAgg(figure)
    figure.subplots(1, columns)
    return figure


def bottom_hole(result: "RunResult") -> "Figure":
    """The hole from above, x right and y down the page as the driller sees it; rock removed in every step, over turns."""
    figure = _figure(2)
    hole, removed = figure.axes
    x, y, z = 1e3 * result.rock.vertices.T
    colours = hole.tripcolor(x, y, result.rock.faces, z, shading="gouraud", cmap="viridis_r")
    figure.colorbar(colours, ax=hole, label="depth, mm")
    hole.set(aspect="equal", xlabel="x, mm", ylabel="y, mm", title=result.summary["title"])
    hole.invert_yaxis()
    history = result.history
    turns = np.asarray(history["rotation_angle"]) / (2 * np.pi)
    removed.plot(turns, 1e6 * np.asarray(history["removed_volume_total"]))
    removed.set(xlabel="revolutions", ylabel="rock removed, cm$^3$")
    return figure


def axis_path(result: "RotationResult") -> "Figure":
    """The third axis of the body from above; how far the energy drifts."""
    figure = _figure(2)
    path, energy = figure.axes
    history = result.history
    axis = np.asarray(history["axis_W"])
    path.plot(axis[:, 0], axis[:, 1], linewidth=0.8)
    path.set(aspect="equal", xlabel="x of the axis", ylabel="y of the axis", title=result.summary["title"])
    drift = np.asarray(history["total_energy"]) - result.summary["energy_start"]
    energy.plot(np.asarray(history["time"]), drift / result.summary["energy_scale"], linewidth=0.8)
    energy.set(xlabel="time, s", ylabel="change of the energy over its scale")
    return figure


def errors(study: "Convergence") -> "Figure":
    """Errors over the quantity that was divided, each over its scale."""
    figure = _figure(1)
    axes = figure.axes[0]
    for variable, values in study.errors.items():
        found = study.data["variables"][variable]
        order = "no order" if found["order"] is None else f"order {found['order']:.2f}"
        axes.loglog(study.sizes[:len(values)], values / found["scale"], "o-", label=f"{variable}: {order}")
    axes.set(xlabel=study.data["over"], ylabel=f"difference to the {study.data['against']} over the scale")
    axes.legend(fontsize=7)
    return figure
