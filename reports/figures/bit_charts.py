"""A designer's charts of a fixed-cutter bit, of analysis.json alone. Lengths in mm, angles in degrees."""

import numpy as np

from figures import bit_scene, style

MM = 1e3
WIDE, TALL = (7.4, 2.7), (7.4, 4.2)


def rz(points):
    """(r, z) in mm of a list of places in the half-plane; z up in the chart."""
    places = MM * np.array(points, dtype=float).reshape(-1, 2)
    return places[:, 0], places[:, 1]


def half_plane(axes):
    axes.set(xlabel="radius (mm)", ylabel="z (mm, down)", aspect="equal")
    axes.invert_yaxis()
    axes.axvline(0.0, color=style.GREY, linewidth=0.8, linestyle="-.")


def blades(bit):
    return sorted({c["blade"] for c in bit.cutters})


def blade_legend(axes, bit, **options):
    handles = [axes.plot([], [], "s", color=bit_scene.blade_colour(b), label=f"blade {b}")[0] for b in blades(bit)]
    axes.legend(handles=handles, **{"ncol": 1, "loc": "upper left", "bbox_to_anchor": (1.0, 1.0), **options})


def colours(bit):
    return [bit_scene.blade_colour(c["blade"]) for c in bit.cutters]


def draw_outlines(axes, bit, numbers=True):
    """Fig. 3.8: every cutter turned into one half-plane, with the bit's profiles."""
    if body := bit.analysis.get("body_profile_rz_m"):
        r, z = rz(body)
        axes.fill_between(r, z, min(z.min(), MM * bit.profile[:, 1].min()), color="0.93", linewidth=0)
    for cutter in bit.cutters:
        r, z = rz(cutter["outline_rz_m"])
        colour = bit_scene.blade_colour(cutter["blade"])
        axes.fill(r, z, facecolor=colour, edgecolor=colour, alpha=0.13, linewidth=0)
        axes.plot(np.append(r, r[0]), np.append(z, z[0]), color=colour, linewidth=0.7,
                  linestyle="--" if cutter["under_exposure_m"] > 0 else "-")
        if numbers:
            axes.annotate(cutter["name"].split("-")[-1], (r.mean(), z.mean()), fontsize=5.5, ha="center",
                          va="center", color=colour)
    axes.plot(*rz(bit.profile), color=style.BLACK, linewidth=1.5, label="exposure profile")


def show_cutters(axes, bit):
    """The part of the half-plane where cutters are."""
    reach = [p for c in bit.cutters for p in c["outline_rz_m"]]
    r, z = rz(reach)
    axes.set_xlim(-2, r.max() + 3)
    axes.set_ylim(z.max() + 3, z.min() - 3)


def profile(bit):
    figure, axes = style.panels(1, 1, (7.4, 4.9))
    draw_outlines(axes, bit)
    half_plane(axes)
    show_cutters(axes, bit)
    blade_legend(axes, bit)
    return figure


def by_radius(axes, bit, label):
    axes.set(xlabel="radius of the tip (mm)", ylabel=label, xlim=(0, 1.02 * MM * bit.analysis["gage_radius_m"]))


def exposure(bit):
    figure, (over, under) = style.panels(2, 1, TALL, sharex=True)
    r = MM * bit.column("tip_radius_m")
    value = MM * bit.column("exposure_m")
    known = np.isfinite(value)
    over.vlines(r[known], 0, value[known], colors=np.array(colours(bit))[known], linewidth=1.2)
    over.scatter(r[known], value[known], c=np.array(colours(bit))[known], s=16, zorder=3)
    over.axhline(0, color=style.BLACK, linewidth=0.8)
    by_radius(over, bit, "over the others'\nenvelope (mm)")
    over.set_xlabel("")
    overlap = 100 * bit.column("overlap_with_next")
    known = np.isfinite(overlap)
    under.scatter(r[known], overlap[known], c=np.array(colours(bit))[known], s=16, zorder=3)
    by_radius(under, bit, "overlap with the\nnext tip (% of D)")
    blade_legend(over, bit)
    return figure


def rakes(bit):
    figure, axes = style.panels(1, 1, WIDE)
    r = MM * bit.column("tip_radius_m")
    for key, marker, label in (("back_rake_rad", "o", "back rake"), ("side_rake_rad", "^", "side rake")):
        values = np.degrees(bit.column(key))
        axes.plot(r[np.argsort(r, kind="stable")], values[np.argsort(r, kind="stable")], color="0.8", linewidth=0.8)
        axes.scatter(r, values, c=colours(bit), marker=marker, s=18, zorder=3)
        axes.scatter([], [], color=style.GREY, marker=marker, s=18, label=label)
    by_radius(axes, bit, "rake (deg)")
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


def bars(axes, bit, values, label):
    width = 0.5 * MM * bit.analysis["gage_radius_m"] / max(20, len(bit.cutters))
    axes.bar(MM * bit.column("tip_radius_m"), values, width, color=colours(bit), edgecolor="white", linewidth=0.3,
             alpha=0.9)
    by_radius(axes, bit, label)


def loads(bit):
    """Volume a revolution and cut area of every cutter."""
    figure, (volume, area) = style.panels(2, 1, TALL, sharex=True)
    bars(volume, bit, 1e9 * bit.column("volume_m3_per_rev"), "volume (mm$^3$/rev)")
    volume.set_xlabel("")
    bars(area, bit, 1e6 * bit.column("area_m2"), "cut area (mm$^2$)")
    blade_legend(volume, bit)
    return figure


def redundancy(bit):
    """How many cutters cut at each radius."""
    figure, axes = style.panels(1, 1, (7.4, 2.3))
    count = np.array(bit.analysis["cutters_cutting_at_radius"])
    edges = MM * bit.analysis["column_width_m"] * np.arange(len(count) + 1)
    axes.stairs(count, edges, fill=True, color=style.SKY, alpha=0.6)
    axes.stairs(count, edges, color=style.BLUE, linewidth=1.0, baseline=None)
    mean = bit.analysis["mean_redundancy"]
    axes.axhline(mean, color=style.RED, linewidth=1.0, label=f"mean by area: {mean:.2f}")
    axes.yaxis.get_major_locator().set_params(integer=True)
    axes.set(xlabel="radius (mm)", ylabel="cutters that cut", ylim=(0, max(count.max(), 1) + 0.6), xlim=(0, edges[-1]))
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


def weight(bit):
    """Weight over depth of cut, per MPa of the rock's strength, with its slopes before and after the body touches."""
    figure, axes = style.panels(1, 1, (7.4, 3.0))
    body = bit.analysis["body"]
    curve = body["weight_over_depth_of_cut"]
    n_per_m2 = 1e6  # at 1 MPa
    depth = MM * np.array(curve["depth_of_cut_m_per_rev"])
    axes.plot(depth, n_per_m2 * curve["slope_m"] * depth / MM, color=style.BLACK, linewidth=1.0, linestyle="--", label="cutters alone")
    axes.plot(depth, n_per_m2 * np.array(curve["weight_over_strength_m2"]), color=style.BLUE, label="cutters and body")
    axes.axvline(MM * body["touches_at_m_per_rev"], color=style.RED, linewidth=1.0, label="the body touches")
    axes.set(xlabel="depth of cut (mm/rev)", ylabel="weight (N per MPa of strength)", xlim=(0, depth[-1]), ylim=(0, None))
    axes.legend(loc="upper left")
    return figure


def forces(bit):
    """(n, 2): of the unit law, every cutter's lateral push over the sum of all pushes, by azimuth."""
    area = bit.column("area_m2")
    order = np.argsort(bit.column("azimuth_rad") % (2 * np.pi), kind="stable")
    normal = np.array([c["profile_normal"] for c in bit.cutters])[:, :2]
    return order, (area[:, None] * normal / area.sum())[order]


def imbalance(bit):
    """The lateral pushes of the unit law head to tail: what is left over is the imbalance."""
    figure, (chain, result) = style.panels(1, 2, (7.4, 3.5))
    order, pushes = forces(bit)
    path = 100 * np.vstack([[0, 0], np.cumsum(pushes, axis=0)])
    for k, cutter in enumerate(order):
        chain.annotate("", path[k + 1], path[k], arrowprops={
            "arrowstyle": "-|>", "color": colours(bit)[cutter], "linewidth": 1.3, "shrinkA": 0, "shrinkB": 0,
            "mutation_scale": 7})
    chain.plot(*path.T, alpha=0)
    left = 100 * np.array(bit.analysis["imbalance_vector_of_unit_law"])[:2]
    size = 100 * bit.analysis["imbalance_of_unit_law"]
    for axes in (chain, result):
        axes.annotate("", left, (0, 0), arrowprops={"arrowstyle": "-|>", "color": style.BLACK, "linewidth": 2.2,
                                                    "shrinkA": 0, "shrinkB": 0})
        axes.set(xlabel="x (% of all pushes)", ylabel="y", aspect="equal")
        axes.invert_yaxis()  # seen from above, z away from the reader
    reach = 1.5 * max(size, 0.5)
    result.set(xlim=(-reach, reach), ylim=(reach, -reach))
    for ring in (0.5 * size, size):
        result.add_patch(style.circle(ring))
    angle = np.degrees(np.arctan2(left[1], left[0]))
    result.set_title(f"{size:.2f} % towards {angle:.0f} deg")
    chain.set_title("every cutter, head to tail")
    return figure


def directions(bit):
    """Profile normals and update directions at azimuth 0 (eqs. 4.1 and 4.2)."""
    figure, axes = style.panels(1, 1, (7.4, 4.8))
    draw_outlines(axes, bit, numbers=False)
    tip = MM * np.column_stack([bit.column("tip_radius_m"), -bit.column("tip_height_m")])
    angle = bit.column("profile_angle_rad")
    own = {p["cutter"]: p["update_direction"] for p in bit.parts if p["cutter"] >= 0}
    update = np.array([[own[k][0], own[k][2]] for k in range(len(bit.cutters))])
    for vectors, colour, label in ((np.column_stack([np.sin(angle), np.cos(angle)]), style.GREY, "profile's normal"),
                                   (update, bit_scene.MAGENTA, "update direction")):
        axes.quiver(*tip.T, *vectors.T, color=colour, angles="xy", scale_units="xy", scale=0.11, width=0.0028,
                    label=label, zorder=4)
    half_plane(axes)
    show_cutters(axes, bit)
    axes.set_ylim(axes.get_ylim()[0] + 9, axes.get_ylim()[1])
    axes.set_xlim(axes.get_xlim()[0], axes.get_xlim()[1] + 9)
    axes.legend(loc="upper left", bbox_to_anchor=(0.0, 1.0))
    return figure
