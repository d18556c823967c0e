"""What the 3-D page shows of the parts of a bit: colours by kind, and for each cutter, row of teeth or other part its name, its place in the
layout, and its mean force and area of cut in the run."""

from pathlib import Path

import numpy as np

from figures import bit_scene, results

KINDS = ("face", "chamfer", "cse", "cutter-body", "gage-pad", "bit-body", "cone", "tooth")  # by their numbers in bit_final.vtp
HULL = KINDS.index("bit-body")
COLOURS = {"face": "#20262e", "chamfer": "#f0b429", "cse": "#7b4fa3", "cutter-body": "#4f8fbf", "gage-pad": "#c2571a",
           "bit-body": "#b4bfca", "cone": "#cdb79e", "tooth": "#3d4653"}
WORDS = {"face": "faces of cutters", "chamfer": "chamfers", "cse": "carbide edges", "cutter-body": "bodies of cutters", "gage-pad": "gage pads",
         "bit-body": "body of the bit", "cone": "cones", "tooth": "teeth"}


def look(kind, cone):
    """(words, colour) of a triangle of a kind; teeth have the colour of their cone."""
    name = KINDS[kind]
    if name == "tooth" and cone >= 0:
        return f"teeth of cone {cone + 1}", bit_scene.cone_colour(cone)
    return WORDS[name], COLOURS[name]


def looks(bit):
    """(words, colours, number of each triangle's) of a mesh of the bit."""
    kind = bit.cell_values["kind"].astype(int)
    cone = bit.cell_values.get("cone", np.full(len(kind), -1.0)).astype(int)
    pairs, number = np.unique(np.stack([kind, cone], axis=1), axis=0, return_inverse=True)
    found = [look(*pair) for pair in pairs]
    names = list(dict.fromkeys(words for words, _ in found))
    colours = [next(c for words, c in found if words == name) for name in names]
    return names, colours, np.array([names.index(words) for words, _ in found])[number.ravel()]


def group_of(part):
    """A cutter of its face, chamfer and body; a row of its teeth."""
    return part.rsplit("/", 1)[0]


def layout(folder):
    """{name: entry} of the cutters of bit.json, and {name: entry} of its parts; empty without that file."""
    if not (Path(folder) / "bit.json").is_file():
        return {}, {}
    bit = results.read_json(folder, "bit.json")
    return {c["name"]: c for c in bit.get("cutters", [])}, {p["name"]: p for p in bit.get("parts", [])}


def place_facts(cutter):
    """[(what, value)] of a cutter of the layout."""
    degrees = lambda key: f"{np.degrees(cutter[key]):.4g}\u00b0"  # noqa: E731
    return [("blade, zone", f"{cutter['blade']}, {cutter['zone']}"), ("radius of the tip", f"{1e3 * cutter['tip_radius_m']:.5g} mm"),
            ("azimuth", degrees("azimuth_rad")), ("height above the nose", f"{1e3 * cutter['tip_height_m']:.5g} mm"),
            ("profile angle", degrees("profile_angle_rad")), ("back rake, side rake", f"{degrees('back_rake_rad')}, {degrees('side_rake_rad')}"),
            ("diameter, chamfer", f"{1e3 * cutter['diameter_m']:.4g} mm, {1e3 * cutter['chamfer_m']:.3g} mm")]


def newtons(value):
    return f"{value:.0f} N" if abs(value) < 1000 else f"{1e-3 * value:.4g} kN"


def load_facts(loads, area, volume):
    """[(what, value)] of a group in the run. `loads`: its parts' entries of `forces` in summary.json."""
    rows = []
    for key, what in (("normal_mean_n", "mean normal force"), ("tangential_mean_n", "mean drag")):
        if loads:
            each = [f"{f['name'].rsplit('/', 1)[-1]} {newtons(f[key])}" for f in loads if f[key]]
            rows.append((what, newtons(sum(f[key] for f in loads)) + (f" ({', '.join(each)})" if 1 < len(each) < 5 else "")))
    if area is not None:
        rows.append(("mean area of cut", f"{1e6 * area:.4g} mm\u00b2"))
    return [*rows, ("rock removed in the run", f"{1e6 * volume:.4g} cm\u00b3")]


def groups(folder, run):
    """({group: number}, entries of the header) of all parts of the bit, in their order. Each entry has a name, facts, and mean forces (N;
    None in a run without a force law), which are sums over the surfaces of the group."""
    cutters, parts = layout(folder)
    volumes, areas = run["removed_volume_by_part_m3"], {s["name"]: s.get("mean_area_m2") for s in run.get("sections", [])}
    loads = {}
    for f in run.get("forces", []):
        loads.setdefault(group_of(f["name"]), []).append(f)
    entries = []
    for name in dict.fromkeys(map(group_of, volumes)):
        own, of = [p for p in volumes if group_of(p) == name], loads.get(name, [])
        kinds = list(dict.fromkeys(parts[p]["kind"] for p in own if p in parts))
        facts = [("kind", ", ".join(kinds))] if kinds else []
        facts += place_facts(cutters[name]) if name in cutters else []
        entries.append({"name": name, "facts": facts + load_facts(of, areas.get(name), sum(volumes[p] for p in own)),
                        "normal_n": sum(f["normal_mean_n"] for f in of) if of else None,
                        "tangential_n": sum(f["tangential_mean_n"] for f in of) if of else None})
    return {e["name"]: k for k, e in enumerate(entries)}, entries
