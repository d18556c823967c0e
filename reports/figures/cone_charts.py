"""Charts of a roller cone bit: what its rows sweep, how fast its cones roll, where its teeth are."""

import numpy as np

from figures import bit_scene, style
from figures.bit_charts import MM, half_plane, rz


def closed(points):
    r, z = rz(points)
    return np.append(r, r[0]), np.append(z, z[0])


def profile(bit):
    """The meridians of shells and rows, where each cone is deepest, turned into one half-plane."""
    figure, axes = style.panels(1, 1, (7.4, 4.3))
    for k, cone in enumerate(bit.cones):
        colour = bit_scene.cone_colour(k)
        for section in cone["sections"]:
            r, z = closed(section["meridian_rz_m"])
            if section["part"] == "shell":
                axes.plot(r, z, color=colour, linewidth=0.8, alpha=0.6)
            else:
                axes.fill(r, z, facecolor=colour, edgecolor=colour, alpha=0.35, linewidth=1.0)
                axes.annotate(section["part"].split("-")[-1], (r.mean(), z.max()), textcoords="offset points",
                              xytext=(0, -9), fontsize=7, ha="center", color=colour)
        axes.plot([], [], color=colour, linewidth=5, alpha=0.5, label=cone["name"])
    axes.plot(*rz(bit.profile), color=style.BLACK, linewidth=1.3, label="exposure profile\nas the cones turn")
    half_plane(axes)
    deepest = max(rz(s["meridian_rz_m"])[1].max() for c in bit.cones for s in c["sections"])
    highest = min(rz(s["meridian_rz_m"])[1].min() for c in bit.cones for s in c["sections"])
    axes.set_ylim(deepest + 7, highest - 3)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


def cone_profiles(bit):
    """Each cone about its journal: its shell and what its rows sweep."""
    figure, panels = style.panels(1, len(bit.cones), (7.4, 2.9), sharex=True, sharey=True, squeeze=False)
    for k, (axes, cone) in enumerate(zip(panels[0], bit.cones)):
        colour = bit_scene.cone_colour(k)
        for section in cone["sections"]:
            s, r = rz(section["meridian_sr_m"])
            if section["part"] == "shell":
                axes.fill_between(s, r, color="0.9", linewidth=0)
                axes.plot(s, r, color=style.GREY, linewidth=1.0)
            else:
                axes.fill(s, r, facecolor=colour, edgecolor=colour, alpha=0.45, linewidth=1.0)
        axes.set(title=cone["name"], xlabel="along the journal (mm)", aspect="equal")
    panels[0][0].set_ylabel("from the journal (mm)")
    return figure


def speeds(bit):
    """The cone's speed over the bit's at which each row would roll; rows of one cone disagree, so teeth slide."""
    figure, axes = style.panels(1, 1, (7.4, 2.7))
    for k, cone in enumerate(bit.cones):
        rows = cone["rows"]
        axes.plot([MM * r["tip_bit_radius_m"] for r in rows], [r["rolling_ratio"] for r in rows], "o-",
                  color=bit_scene.cone_colour(k), linewidth=0.9, label=cone["name"])
    axes.set(xlabel="radius of the row's tip from the bit's axis (mm)", ylabel="rolling ratio", ylim=(0, None),
             xlim=(0, None))
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


def spacing(bit):
    """The places of the teeth of every row about the journal."""
    figure, panels = style.panels(1, len(bit.cones), (7.4, 2.7), squeeze=False, subplot_kw={"aspect": "equal"})
    widest = MM * max(r["tip_cone_radius_m"] for c in bit.cones for r in c["rows"])
    for k, (axes, cone) in enumerate(zip(panels[0], bit.cones)):
        for row in cone["rows"]:
            radius, angle = MM * row["tip_cone_radius_m"], np.array(row["angles_rad"])
            axes.add_patch(style.circle(radius))
            axes.plot(radius * np.cos(angle), radius * np.sin(angle), "s" if row["gage"] else "o",
                      color=bit_scene.cone_colour(k), markersize=4)
        axes.set(title=f"{cone['name']}: {', '.join(str(r['teeth']) for r in cone['rows'])} teeth",
                 xlim=(-1.15 * widest, 1.15 * widest), ylim=(-1.15 * widest, 1.15 * widest))
        axes.set_axis_off()
    return figure


def tracking(bit):
    """Left: prints that fall into one of the last revolution, row by row; right: of all rows, against the cones' speed."""
    figure, (left, right) = style.panels(1, 2, (7.4, 3.2))
    rows = [(k, j, row) for k, cone in enumerate(bit.cones) for j, row in enumerate(cone["rows"]) if row["tracking_share"] is not None]
    for y, (k, _, row) in enumerate(rows):
        left.barh(y, 100 * row["tracking_share"], color=bit_scene.cone_colour(k), alpha=0.6)
        left.plot([100 * row["tracking_share_random_phase"]] * 2, [y - 0.4, y + 0.4], color=style.BLACK, linewidth=1.4)
    left.set_yticks(range(len(rows)), [f"{k + 1}/{j + 1}" for k, j, _ in rows], fontsize=7)
    left.invert_yaxis()
    left.set(xlabel="tracking (% of prints)", ylabel="cone/row", xlim=(0, 100))
    sweep = bit.analysis["tracking"]["sweep"]
    right.plot(sweep["speed_ratio"], [100 * s for s in sweep["tracking_share"]], color=style.BLACK, linewidth=1.0)
    right.plot(sweep["speed_ratio"], [100 * s for s in sweep["tracking_share_random_phase"]], "--", color=style.GREY)
    for k, cone in enumerate(bit.cones):
        right.axvline(cone["speed_ratio"], color=bit_scene.cone_colour(k), linewidth=1.0)
    right.set(xlabel="speed of all cones over the bit's", ylabel="tracking of all rows (%)", ylim=(0, None))
    return figure


def contacts(bit):
    """How many teeth of each row are on the bottom at once."""
    figure, axes = style.panels(1, 1, (7.4, 2.5))
    for k, cone in enumerate(bit.cones):
        axes.plot([MM * r["tip_bit_radius_m"] for r in cone["rows"]], [r["tooth_contact_ratio"] for r in cone["rows"]], "o-",
                  color=bit_scene.cone_colour(k), linewidth=0.9, label=cone["name"])
    axes.set(xlabel="radius of the row's tip from the bit's axis (mm)", ylabel="tooth contact ratio", ylim=(0, None), xlim=(0, None))
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure
