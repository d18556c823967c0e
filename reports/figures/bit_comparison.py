"""Charts of two bits side by side, of reports/compared_bits.py: profiles, forces and work rates of the cutters, lateral forces."""

import numpy as np

from figures import bit_scene, hole_pictures, render, rock_scene, style

MM, KN = 1e3, 1e-3
LOOKS = ((style.BLUE, "o"), (style.RED, "^"))
INCHES = (3.6, 3.6)


def names_above(axes, sides):
    """A legend above the axes, so that it covers no data."""
    handles = [axes.plot([], [], marker=marker, color=colour, label=side.name)[0] for side, (colour, marker) in zip(sides, LOOKS)]
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2)


def profile(sides):
    """Both profiles in one half-plane; thin: the rims of the cutters. Of runs: the tips."""
    figure, axes = style.panels(1, 1, (7.6, 4.8))
    for side, (colour, marker) in zip(sides, LOOKS):
        lowest = side.profile[:, 1].max() if len(side.profile) else np.nanmax(-side.height) if np.isfinite(side.height).any() else 0.0
        for outline in side.outlines:
            axes.fill(MM * outline[:, 0], MM * (outline[:, 1] - lowest), facecolor="none", edgecolor=colour, linewidth=0.5, alpha=0.45)
        if len(side.profile):
            axes.plot(MM * side.profile[:, 0], MM * (side.profile[:, 1] - lowest), color=colour, linewidth=1.8)
        else:
            axes.plot(MM * side.radius, MM * (-side.height - lowest), marker, color=colour)
    axes.set(xlabel="radius (mm)", ylabel="z over the lowest point (mm, down)", aspect="equal")
    reach = MM * max(side.radius.max() for side in sides)
    heights = [MM * (o[:, 1] - s.profile[:, 1].max()) for s in sides if len(s.profile) for o in s.outlines]
    if heights:
        axes.set_ylim(3.0, min(h.min() for h in heights) - 3.0)
    else:
        axes.invert_yaxis()
    axes.set_xlim(-2.0, 1.08 * reach)
    names_above(axes, sides)
    return figure


def by_cutter(sides, quantities):
    """Panels of quantities of every cutter over the radius of its tip: [(label, function of a side)]."""
    figure, axes = style.panels(len(quantities), 1, (7.6, 0.7 + 2.0 * len(quantities)), sharex=True, squeeze=False)
    for panel, (label, values) in zip(axes[:, 0], quantities):
        for side, (colour, marker) in zip(sides, LOOKS):
            order = np.argsort(side.radius, kind="stable")
            panel.plot(MM * side.radius[order], values(side)[order], color=colour, linewidth=0.5, alpha=0.5)
            panel.plot(MM * side.radius, values(side), marker, color=colour, markersize=4.5, alpha=0.85)
        panel.set_ylabel(label)
        panel.set_ylim(bottom=0.0)
    axes[-1, 0].set_xlabel("radius of the tip (mm)")
    names_above(axes[0, 0], sides)
    return figure


def forces(sides):
    return by_cutter(sides, [("normal force (kN)", lambda s: KN * s.normal), ("drag (kN)", lambda s: KN * s.drag)])


def work(sides):
    quantities = [("work rate (W)", lambda s: s.power)]
    if all(np.isfinite(s.area).all() for s in sides):
        quantities.append(("cut area (mm$^2$)", lambda s: MM**2 * s.area))
    return by_cutter(sides, quantities)


def pushes(sides):
    """Lateral forces on the bit over its weight, as arrows; one panel for each bit, on one scale."""
    figure, axes = style.panels(1, 2, (7.6, 4.0), sharex=True, sharey=True)
    colours = dict(zip(dict.fromkeys(name for s in sides for name in s.pushes), (style.BLUE, style.GOLD, style.BLACK, style.GREEN)))
    reach = 125.0 * max(max(np.hypot(*push) for push in s.pushes.values()) for s in sides) or 1.0
    for panel, side in zip(axes, sides):
        for name, push in side.pushes.items():
            panel.annotate("", 100 * push, (0, 0), arrowprops={"arrowstyle": "-|>", "color": colours[name], "linewidth": 1.8, "shrinkA": 0,
                                                              "shrinkB": 0})
            panel.plot([], [], color=colours[name], label=f"{name}: {100 * np.hypot(*push):.2f} %")
        panel.set(xlim=(-reach, reach), ylim=(reach, -reach), aspect="equal", xlabel="x (% of the weight)")
        panel.set_title(side.name)
        panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), fontsize=8)
    axes[0].set_ylabel("y (% of the weight)")
    return figure


def views(sides, dpi):
    """Both bits from below, on one scale. None if a mesh is missing."""
    if any(side.mesh is None for side in sides):
        return None
    figure, frames = bit_scene.canvas(2, INCHES)
    cameras = [rock_scene.camera(side.mesh.points, bit_scene.BELOW, INCHES, dpi=dpi) for side in sides]
    width = max(camera.width for camera in cameras)
    for axes, side, camera in zip(frames, sides, cameras):
        same = render.Camera(camera.toward, camera.up, camera.centre, width, camera.pixels)
        bit_scene.show(axes, render.picture(same, hole_pictures.bit_layer(side.mesh)))
        axes.text(0.02, 0.98, side.name, transform=axes.transAxes, va="top", fontsize=9)
    return figure
