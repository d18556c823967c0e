"""Single operations on rock (thesis 2.1, 4.2, 4.3, 4.10 to 4.24), drawn from tables that tests record. Lengths in mm."""

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Polygon, Rectangle
from matplotlib.ticker import MaxNLocator

from figures import style

# The table one-step: a cutter at two poses, its motion box, the rock's vertices near it. Lengths in mm.

MM = 1e3
MAGENTA = "#d6139a"
STATES = (("passed over by the search", "0.75", 4), ("offered by it, not swept", style.BLUE, 8), ("swept by the cutter", style.RED, 11))


def xy(points):
    return np.asarray(points)[..., :2]


def rz(points):
    """Radius and depth."""
    points = np.asarray(points)
    return np.stack([np.hypot(points[..., 0], points[..., 1]), points[..., 2]], axis=-1)


def hull(points):
    """Corners of the convex hull of points in a plane, in order: one chain from left to right, one back."""
    corners = []
    for chain in (np.unique(points, axis=0), np.unique(points, axis=0)[::-1]):
        start = len(corners)
        for p in chain:
            while len(corners) > start + 1 and turn(corners[-2], corners[-1], p) <= 0:
                corners.pop()
            corners.append(p)
        corners.pop()
    return np.array(corners)


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


class Step:
    """The table as arrays."""

    def __init__(self, rows):
        vertices = [r for r in rows if r["what"] == "vertex"]
        self.start, self.end = (MM * np.array([v[k] for v in vertices]) for k in ("from", "to"))
        self.direction = np.array([v["direction"] for v in vertices])
        self.state = np.array([2 if v["moved"] else int(v["candidate"]) for v in vertices])
        self.cutter = [MM * np.array([r["corners"] for r in rows if r["what"] == "part" and r["pose"] == k]).reshape(-1, 3)
                       for k in (0, 1)]
        [box] = [r for r in rows if r["what"] == "box"]
        self.box = MM * np.array([box["low"], box["high"]])

    def draw_cutter(self, axes, plane, pose, **look):
        outline = plane(self.cutter[pose])
        axes.add_patch(Polygon(hull(outline), **look))

    def draw_both(self, axes, plane):
        self.draw_cutter(axes, plane, 0, facecolor="none", edgecolor=style.GREY, linestyle="--", linewidth=1.0)
        self.draw_cutter(axes, plane, 1, facecolor="0.88", edgecolor=style.BLACK, linewidth=1.0, alpha=0.7, zorder=0)

    def draw_vertices(self, axes, plane):
        for state, (_, colour, size) in enumerate(STATES):
            axes.scatter(*plane(self.start[self.state == state]).T, s=size, color=colour, linewidths=0, zorder=2 + state)

    def draw_box(self, axes):
        low, high = self.box[:, :2]
        axes.add_patch(Rectangle(low, *(high - low), fill=False, edgecolor=style.GOLD, linewidth=1.6))


def name_planes(above, section):
    above.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
    above.invert_yaxis()
    above.set_title("from above the hole", loc="left")
    section.set(xlabel="distance from the axis of the hole (mm)", ylabel="z (mm, down)", aspect="equal")
    section.invert_yaxis()
    section.set_title("turned into one half-plane through the axis", loc="left")


def legend_below(figure, handles):
    figure.get_layout_engine().set(rect=(0, 0.11, 1, 0.89))
    figure.legend(handles=handles, loc="lower center", ncol=3)


def motion_box(inputs):
    """For figures 4.2 and 4.3: the motion box of a cutter, what the search finds in it, what was swept."""
    if inputs.table("one-step") is None:
        return style.only_words("one step of one cutter")
    step = Step(inputs.table("one-step"))
    figure, (above, section) = style.panels(1, 2, (10.4, 5.2))
    for axes, plane in ((above, xy), (section, rz)):
        step.draw_both(axes, plane)
        step.draw_vertices(axes, plane)
    step.draw_box(above)
    name_planes(above, section)
    handles = [above.scatter([], [], s=20, color=c, label=f"{w}: {(step.state == k).sum()}") for k, (w, c, _) in enumerate(STATES)]
    handles += above.plot([], [], color=style.GOLD, label="motion box, in x and y")
    handles += above.plot([], [], "--", color=style.GREY, label="cutter before the step")
    handles += above.plot([], [], color=style.BLACK, label="cutter after it")
    legend_below(figure, handles)
    return figure


def exit_search(inputs):
    """Figure 4.14: the search for where a vertex leaves a part, from plane to plane."""
    if inputs.table("search") is None:
        return style.only_words("the search for an exit")
    rows = inputs.table("search")
    levels = [r for r in rows if r["what"] == "level"]
    [exit_row] = [r for r in rows if r["what"] == "exit"]
    tau, t = np.array([r["tau"] for r in levels]), MM * np.array([r["t"] for r in levels])
    plane = np.array([r["plane"] for r in levels])
    figure, axes = style.panels(1, 1, (7.0, 4.4))
    whole = np.array([0.0, 1.0])
    for k, row in enumerate(r for r in rows if r["what"] == "plane"):
        if row["up"] > 1e-12:
            line = MM * (row["rest"] - row["along"] * whole) / row["up"]
            axes.plot(whole, line, color=style.BLUE if k in plane else "0.8", linewidth=1.0 if k in plane else 0.7, zorder=1)
    axes.fill_between(tau, 0, t, color=style.SKY, alpha=0.25, linewidth=0)
    axes.plot(tau, t, color=style.BLACK, linewidth=2.2)
    top = np.argmax(t)
    axes.plot(tau[top], MM * exit_row["t"], "o", color=style.RED, markersize=7, zorder=5)
    axes.annotate("exit found by the search", (tau[top], MM * exit_row["t"]), xytext=(0, 14),
                  textcoords="offset points", ha="center", color=style.RED, bbox={"color": "white", "pad": 1.5})
    axes.axvspan(exit_row["from"], exit_row["to"], ymax=0.02, color=style.GOLD)
    axes.plot([], [], color=style.GOLD, linewidth=4, label="when the vertex itself is inside")
    axes.plot([], [], color=style.BLUE, label="planes that bound the exit"), axes.plot([], [], color="0.8", label="other planes")
    axes.plot([], [], color=style.BLACK, linewidth=2.2, label="where the ray at that time leaves the part")
    axes.set(xlim=(0, 1), ylim=(0, 1.6 * t.max()), xlabel="fraction of the step, tau", ylabel="distance along the update direction, t (mm)")
    axes.legend(loc="center", bbox_to_anchor=(0.5, 0.3), ncol=1)
    return figure


def mapped_vertices(inputs):
    """Figure 4.12: the update direction of a cutter, turned to the azimuth of each vertex, and where vertices went."""
    if inputs.table("one-step") is None:
        return style.only_words("one step of one cutter")
    step = Step(inputs.table("one-step"))
    moved = step.state == 2
    start, end, direction = step.start[moved], step.end[moved], step.direction[moved]
    figure, (above, section) = style.panels(1, 2, (10.4, 5.2))
    for axes, plane in ((above, xy), (section, rz)):
        step.draw_both(axes, plane)
        axes.scatter(*plane(start).T, s=9, color=style.RED, linewidths=0, zorder=4)
        axes.scatter(*plane(end).T, s=9, color=style.BLUE, linewidths=0, zorder=4)
        way = plane(end) - plane(start)
        axes.quiver(*plane(start).T, *way.T, angles="xy", scale_units="xy", scale=1, color=MAGENTA, width=0.0025, zorder=3)
    name_planes(above, section)
    frame_around(above, xy(np.concatenate([start, end])), 3.0)
    frame_around(section, rz(np.concatenate([start, end])), 3.0)
    section.text(0.02, 0.02, f"turned back by their azimuths\nall directions then agree to {spread(start, direction):.0e} rad",
                 transform=section.transAxes, va="bottom", fontsize=8)
    handles = [above.scatter([], [], s=20, color=style.RED, label="swept vertex before"),
               above.scatter([], [], s=20, color=style.BLUE, label="the same, moved to the exit"),
               *above.plot([], [], color=MAGENTA, label="its path along the mapped update direction")]
    legend_below(figure, handles)
    return figure


def frame_around(axes, points, margin):
    (left, low), (right, high) = points.min(axis=0) - margin, points.max(axis=0) + margin
    axes.set(xlim=(left, right), ylim=(high, low))


def spread(start, direction):
    """Largest angle between the directions in the vertices' own half-planes, rad: the bit's axis is the hole's."""
    azimuth = np.arctan2(start[:, 1], start[:, 0])
    outward = direction[:, 0] * np.cos(azimuth) + direction[:, 1] * np.sin(azimuth)
    angle = np.arctan2(outward, direction[:, 2])
    return max(np.ptp(angle), 1e-16)


def side(rows):
    """Facets that face outward or down: the only ones that meet rock ahead of them."""
    corners = np.array([r["corners"] for r in rows])
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middle = corners.mean(axis=1)
    outward = (normal[:, :2] * middle[:, :2]).sum(axis=1)
    return (normal[:, 2] > 0) | (outward > 0)


def draw_tooth(axes, rows, title):
    outline = MM * rz(np.array([r["corners"] for r in rows]).reshape(-1, 3))
    axes.add_patch(Polygon(hull(outline), facecolor="0.9", edgecolor=style.BLACK))
    place, direction = (np.array([r[k] for r in rows])[side(rows)] for k in ("place", "direction"))
    azimuth = np.arctan2(place[:, 1], place[:, 0])
    outward = direction[:, 0] * np.cos(azimuth) + direction[:, 1] * np.sin(azimuth)
    axes.quiver(*(MM * rz(place)).T, outward, direction[:, 2], color=MAGENTA, angles="xy", scale_units="xy", scale=0.4, width=0.004)
    axes.set(xlabel="distance from the bit's axis (mm)", ylabel="z (mm, down)", aspect="equal")
    axes.set_title(title, loc="left")
    low, high = outline.min(axis=0), outline.max(axis=0)
    axes.set(xlim=(low[0] - 2, high[0] + 4), ylim=(high[1] + 4, low[1] - 2))


def tooth_directions(inputs):
    """Figure 4.10: the directions in which teeth of a roller cone bit move rock, by place on the tooth."""
    if inputs.table("tooth-directions") is None:
        return style.only_words("directions at teeth")
    rows = inputs.table("tooth-directions")
    figure, frames = style.panels(1, 2, (8.6, 4.6))
    for axes, name in zip(frames, ("inner row", "gage row")):
        draw_tooth(axes, [r for r in rows if r["tooth"] == name], f"a tooth of an {name}" if name[0] == "i" else "a tooth of the gage row")
    return figure


GAUSS = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3.0)  # of zeta; the weight of each is a half of the prism's


def largest(rows):
    """Old and new corners of the triangle that swept most of those of which all three corners moved; mm."""
    whole = [r for r in rows if all(a != b for a, b in zip(r["from"], r["to"]))]
    best = max(whole or rows, key=lambda r: r["volume"])
    return MM * np.array(best["from"]), MM * np.array(best["to"]), best["volume"]


def at(old, new, xi, eta, zeta):
    """x = (1 - zeta) x_old(xi, eta) + zeta x_new(xi, eta)."""
    weights = np.array([1 - xi - eta, xi, eta])
    return (1 - zeta) * weights @ old + zeta * weights @ new


def draw_prism(axes, old, new, names):
    for corners, colour in ((old, style.GREY), (new, style.BLUE)):
        closed = np.vstack([corners, corners[:1]])
        axes.plot(*closed.T, color=colour, linewidth=2.0)
    for a, b in zip(old, new):
        axes.plot(*np.stack([a, b]).T, color=style.BLACK, linewidth=0.9, linestyle="--")
    for share in (0.25, 0.5, 0.75):  # the sides between are ruled
        for k in range(3):
            j = (k + 1) % 3
            line = np.stack([(1 - share) * old[k] + share * old[j], (1 - share) * new[k] + share * new[j]])
            axes.plot(*line.T, color="0.7", linewidth=0.6)
    points = np.array([at(old, new, 1 / 3, 1 / 3, z) for z in GAUSS])
    axes.scatter(*points.T, color=style.RED, s=26, depthshade=False)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_major_locator(MaxNLocator(4))
    axes.set(xlabel=names[0], ylabel=names[1], zlabel=names[2])


def prism(inputs):
    """Figures 4.23 and 4.24: the prism between an old and a new triangle, in space and in its own coordinates."""
    if inputs.table("prisms") is None:
        return style.only_words("prisms of a step")
    old, new, volume = largest(inputs.table("prisms"))
    figure = style.Figure(figsize=(10.0, 4.8))
    space = figure.add_subplot(1, 2, 1, projection="3d")
    draw_prism(space, old, new, ("x (mm)", "y (mm)", "z (mm, down)"))
    space.set_aspect("equal")
    space.set_zlim(*reversed(space.get_zlim()))
    space.set_title(f"in space: {1e9 * volume:.3f} mm$^3$ of rock removed")
    own = figure.add_subplot(1, 2, 2, projection="3d")
    flat = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    draw_prism(own, np.column_stack([flat, np.zeros(3)]), np.column_stack([flat, np.ones(3)]), ("xi", "eta", "zeta"))
    own.set_title("in its own coordinates")
    for colour, words in ((style.GREY, "old triangle, zeta = 0"), (style.BLUE, "new triangle, zeta = 1"), (style.RED, "Gauss points")):
        space.plot([], [], [], "s", color=colour, label=words)
    figure.legend(*space.get_legend_handles_labels(), loc="lower center", ncol=3)
    figure.subplots_adjust(left=0.02, right=0.95, bottom=0.14, top=0.92, wspace=0.12)
    return figure


def corners(row):
    points, triangles = np.array(row["positions"]), np.array(row["triangles"])
    return points, triangles


def draw_sheet(axes, row):
    points, triangles = corners(row)
    axes.triplot(points[:, 0], points[:, 1], triangles, color="0.55", linewidth=0.8)
    if "edge" in row:
        axes.plot(*np.array(row["edge"])[:, :2].T, "o-", color=style.RED, linewidth=2.4, markersize=4)
    axes.set(aspect="equal", title=row["stage"])
    axes.set_axis_off()


def sheets(inputs):
    """Figures 4.16, 4.19, 4.21 and 4.22: a small sheet of rock from above, before and after an operation."""
    [(name, table)] = inputs.tables.items()
    if table is None:
        return style.only_words(name)
    figure, frames = style.panels(1, len(table), (3.4 * len(table), 3.6))
    for axes, row in zip(frames, table):
        draw_sheet(axes, row)
        axes.set_title(f"{row['stage']}: {len(row['triangles'])} triangles")
    before = {tuple(p) for p in table[0]["positions"]}
    for axes, row in zip(frames[1:], table[1:]):
        new = np.array([p for p in row["positions"] if tuple(p) not in before])
        if len(new):
            axes.plot(new[:, 0], new[:, 1], "o", color=style.BLUE, markersize=4)
    return figure


WORDS = {"boundary": "boundary: an end is on it", "topology": "topology: the sheet would be pinched",
         "normal": "normal: a triangle would turn over", "overhang": "overhang: rock would hang over",
         "too_long": "too long: an edge would be", "too_short": "too short: an edge would be",
         "quality": "quality: a triangle would be worse", "volume": "volume: too much would change",
         "distance": "distance: the surface would go too far", "ridge": "ridge: it would be cut"}


def refused_collapses(inputs):
    """Figure 4.18: triangles that cannot be deleted, one sheet for each reason of refusal."""
    if inputs.table("refusals") is None:
        return style.only_words("refused collapses")
    table = inputs.table("refusals")
    columns = 4
    rows = -(-len(table) // columns)
    figure, frames = style.panels(rows, columns, (11.6, 3.0 * rows), squeeze=False)
    for axes in frames.ravel():
        axes.set_axis_off()
    for axes, row in zip(frames.ravel(), table):
        draw_sheet(axes, row)
        axes.set_title(WORDS.get(row["stage"], row["stage"]))
    return figure


# key of the tables: (label, colour, marker)
ROCKS = {"mesh": ("our mesh", style.BLUE, "o"), "spoke": ("Langeveld", style.RED, "^"), "outline": ("Hanson and Hansen", style.GREEN, "s")}
GAGE = 107.95  # mm


def draw_window(axes, rows, kind):
    """The points at the gage, from above."""
    shown = [row["points_mm"] for row in rows if row["of"] == kind]
    _, colour, _ = ROCKS[kind]
    if kind == "mesh":
        axes.add_collection(PolyCollection(shown, facecolor="none", edgecolor=colour, linewidth=0.8))
    else:
        for nodes in shown:
            x, y = zip(*nodes)
            axes.plot(x, y, "-", color=style.BLACK, linewidth=0.8)
            axes.plot(x, y, ".", color=colour, markersize=5)
    axes.add_patch(style.circle(GAGE))
    axes.set(aspect="equal", xlim=(97.0, 108.5), ylim=(-6.2, 6.2), xlabel="x (mm)", ylabel="y (mm)")
    axes.grid(False)


def draw_over_radius(axes, rows, key, kinds, line="-", note="", fill="full"):
    for kind in kinds:
        label, colour, marker = ROCKS[kind]
        axes.plot([r["r_mm"] for r in rows], [r[f"{kind}_{key}"] for r in rows], line, color=colour, marker=marker,
                  fillstyle=fill, label=label + note)
    axes.set(xlabel="radius (mm)", xlim=(0.0, 110.0))


def spokes(inputs):
    """Figure 2.1: spokes and our mesh at the gage; distances of points and errors from the axis to the gage."""
    window, steady, whirl, many = map(inputs.table, ("spokes-gage", "spokes-steady", "spokes-whirl", "spokes-whirl-240"))
    if None in (window, steady, whirl, many):
        return style.only_words("Spokes beside the mesh")
    figure, axes = style.panels(2, 3, (10.2, 7.4))
    draw_window(axes[0, 0], window, "spoke")
    axes[0, 0].set_title("120 spokes, 228 nodes each")
    draw_window(axes[0, 1], window, "mesh")
    axes[0, 1].set_title("Our mesh of as many points")
    spacing, still, moved, doubled = axes[0, 2], *axes[1]
    draw_over_radius(spacing, steady, "spacing_mm", ("mesh", "spoke"))
    spacing.plot([r["r_mm"] for r in steady], [r["node_spacing_mm"] for r in steady], ":", color=style.RED, label="nodes of a spoke")
    spacing.set(title="Distance of neighbours", ylabel="mm", ylim=(0.0, 6.0))
    spacing.legend(loc="upper left")
    for at, rows, title in ((still, steady, "Steady, 120 spokes"), (moved, whirl, "Backward whirl, 120 spokes"),
                            (doubled, many, "Backward whirl, 240 spokes")):
        draw_over_radius(at, rows, "error_mm", ROCKS)
        at.set(title=title, ylabel="mean error (mm)", ylim=(0.0, 0.085))
    still.legend(loc="upper left")
    return figure
