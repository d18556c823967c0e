#!/usr/bin/python3
"""Draws a designer's page of a bit, from what `tdbd bit BIT -o FOLDER --report` wrote.

    reports/bit_page.py FOLDER [-o FILE]      one HTML file with everything in it: FOLDER/bit.html

Exit code 2 and one line on what is wrong when the folder contains no such report.
"""

import argparse
import base64
import io
import sys
from pathlib import Path

import system_python

system_python.require("jinja2", "matplotlib", "numpy")

import jinja2
import matplotlib

matplotlib.use("Agg")
from figures import bit_charts, bit_data, bit_pictures, cone_charts  # noqa: E402
from page_tables import tables  # noqa: E402

HERE = Path(__file__).resolve().parent
DPI = 120  # of rendered pictures
matplotlib.rcParams.update({"svg.hashsalt": "tdbd", "svg.fonttype": "path"})


def embedded(figure, form):
    """A figure as a data URL. The same figure gives a bitwise identical URL."""
    kind = {"svg": "svg+xml", "png": "png"}[form]
    metadata = {"svg": {"Date": None, "Creator": None}, "png": {"Software": None}}[form]
    file = io.BytesIO()
    options = {"bbox_inches": "tight"} if form == "svg" else {}
    figure.savefig(file, format=form, dpi=DPI, metadata=metadata, **options)
    return f"data:image/{kind};base64,{base64.b64encode(file.getvalue()).decode()}"


def chart(title, shows, figure):
    return {"title": title, "shows": shows, "image": embedded(figure, "svg")}


def picture(title, shows, figure):
    return {"title": title, "shows": shows, "image": embedded(figure, "png")}


def cutter_charts(bit):
    advance = 1e3 * bit.analysis["penetration_m_per_rev"]
    yield chart("Profile", "Every cutter turned about the bit's axis into one half-plane (fig. 3.8). Thick: the exposure "
                "profile, what the cutting parts reach. Grey: the body. Dashed: back-ups. Numbers are those of the table.",
                bit_charts.profile(bit))
    yield chart("Exposure", "Above: how far each tip stands out, along the profile's normal, of the envelope of all other "
                "rims; negative where others stand out beyond it. Below: the share of a diameter by which a tip overlaps "
                "the next one; back-ups are left out.", bit_charts.exposure(bit))
    yield chart("Rakes", "Back and side rake of every cutter.", bit_charts.rakes(bit))
    yield chart(f"Volume and cut area at {advance:.3g} mm a revolution", "Computed for steady drilling, without a run: the classical "
                "radial plane in closed form. The volumes add up to the hole.", bit_charts.loads(bit))
    yield chart("Redundancy", f"How many cutters remove rock at each radius at {advance:.3g} mm a revolution.",
                bit_charts.redundancy(bit))
    if "body" in bit.analysis:
        curve = bit.analysis["body"]["weight_over_depth_of_cut"]
        n_per_mm = 1e3  # of one metre, at 1 MPa
        yield chart("Weight over depth of cut", f"{n_per_mm * curve['slope_m']:.3g} N/mm for every MPa of the rock's strength until the body "
                    f"touches the rock, {n_per_mm * curve['slope_beyond_touch_m']:.3g} N/mm on average beyond. Assumed: cutters are pushed by "
                    f"{curve['cutting_stress_over_strength']:.3g} strengths times the area that they cut, and what rubs presses with "
                    f"{curve['pressing_stress_over_strength']:.3g} strengths.", bit_charts.weight(bit))
    yield chart("Imbalance of the unit law", "Each cutter pushes along its profile's normal with its cut area times 1 Pa. Left: the "
                "lateral pushes head to tail by azimuth, in shares of the sum of all pushes; the thick arrow is what is left over. Right: "
                "that alone. Seen from above, z away from the reader.", bit_charts.imbalance(bit))
    yield chart("Normals and update directions", "Grey: the profile's normal at each tip. Magenta: the direction in which the cutter "
                "moves rock, at azimuth 0 (eqs. 4.1, 4.2).", bit_charts.directions(bit))


def tracking_charts(bit):
    track = bit.analysis["tracking"]
    yield chart("Tracking", f"How often a tooth falls into a print of the last revolution, closer to it than {track['share_of_width']:.3g} of "
                f"a print's width. Left, bars: row by row at the speeds asked for; lines across: at random phase. Right: all rows, all cones at "
                "one speed; dashed: at random phase; upright: the speeds asked for.", cone_charts.tracking(bit))
    yield chart("Contact ratio", f"How many teeth of a row stand on the bottom at once, {1e3 * track['penetration_m']:.3g} mm deep.",
                cone_charts.contacts(bit))


def cone_chart_list(bit):
    yield chart("Rows", "What the rows sweep in full turns of their cones (filled) and the cones' shells, where each cone is deepest, turned "
                "into one half-plane. Numbers count rows from the nose.", cone_charts.profile(bit))
    yield chart("Cones", "Each cone about its journal: its shell and what its rows sweep.", cone_charts.cone_profiles(bit))
    yield chart("Speeds of rolling", "Speed of the cone over that of the bit at which a row's tip would roll without sliding. A cone has "
                "one speed: rows away from it slide.", cone_charts.speeds(bit))
    if "tracking" in bit.analysis:
        yield from tracking_charts(bit)
    yield chart("Spacing of the teeth", "Along the journal, at the cone's angle 0. Squares: at the gage.", cone_charts.spacing(bit))


def profile_chart(bit):
    figure, axes = bit_charts.style.panels(1, 1, (7.4, 4.3))
    axes.plot(*bit_charts.rz(bit.profile), color=bit_charts.style.BLACK)
    bit_charts.half_plane(axes)
    return chart("Exposure profile", "What the cutting parts reach when all are turned about the bit's axis into one half-plane "
                 "(fig. 3.8).", figure)


def pictures(bit):
    yield picture("The bit", "Left: from below. Right: isometric (figs. 3.2 to 3.5). Colours: blades, or cones.",
                  bit_pictures.draw_views(bit, DPI))
    yield picture("Its coordinate system", "Drawn at the centre of mass (fig. 3.6); x blue, y green, z red and down.",
                  bit_pictures.draw_frame(bit, DPI))
    if bit.cutters:
        yield picture("The cutters' coordinate systems", "Left: all, from below. Right: one, close up (fig. 3.7). x is the face's normal, "
                      "-z lies in the face and points towards the rock.", bit_pictures.draw_cutter_frames(bit, DPI))
        yield picture("A cutter's mesh", "Face and chamfer (fig. 3.9).", bit_pictures.draw_cutters([bit], DPI))
    if bit.cones:
        yield picture("Meshes of teeth", "The first cone, and its visible teeth (fig. 3.10).", bit_pictures.draw_teeth(bit, DPI))
    yield picture("Update directions", "The direction in which each part moves rock, at its azimuth (figs. 4.4, 4.5).",
                  bit_pictures.draw_update_directions(bit, DPI))


def charts(bit):
    if bit.cutters:
        return list(cutter_charts(bit))
    return list(cone_chart_list(bit)) if bit.cones else [profile_chart(bit)]


def html_of(bit):
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
                                     undefined=jinja2.StrictUndefined, lstrip_blocks=True)
    return environment.get_template("bit_page.html.j2").render(
        name=bit.name, pictures=list(pictures(bit)), charts=charts(bit), tables=tables(bit))


def write(folder, path):
    """Writes the page of a report folder, whole or not at all. Raises BadFolder."""
    bit = bit_data.read(folder)
    try:
        html = html_of(bit)
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:
        raise bit_data.BadFolder(f"{folder}/analysis.json: cannot be drawn: {error!r}; write it again with this "
                                 f"program: tdbd bit BIT -o {folder} --report") from error
    partial = Path(f"{path}.partial")
    partial.parent.mkdir(parents=True, exist_ok=True)
    partial.write_text(html, encoding="utf-8")
    partial.rename(path)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=Path, help="what `tdbd bit BIT -o FOLDER --report` wrote")
    parser.add_argument("-o", "--output", type=Path, help="the page (FOLDER/bit.html)")
    chosen = parser.parse_args(arguments)
    path = chosen.output or chosen.folder / "bit.html"
    try:
        write(chosen.folder, path)
    except (bit_data.BadFolder, OSError) as error:
        print(f"bit_page: {error}", file=sys.stderr)
        return 2
    print(f"bit_page: look at {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
