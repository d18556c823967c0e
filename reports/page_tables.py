"""The tables of a bit's page: the numbers of analysis.json. Unknown keys are shown unchanged."""

import numpy as np

BIT_KEYS = {"schema", "name", "gage_radius_m", "penetration_m_per_rev", "imbalance_of_unit_law", "imbalance_vector_of_unit_law",
            "balance", "mean_redundancy", "mass_kg", "centre_m", "inertia_kg_m2", "column_width_m", "cutters_cutting_at_radius", "cutters",
            "parts", "body_profile_rz_m", "cones", "clearances", "tracking", "cutter_overlaps", "cutters_in_body_m3", "body"}
CONE_KEYS = {"axis", "origin_m", "rows", "sections", "assumptions", "tracking_share_by_lag"}  # besides the columns
LISTED = 12  # numbers of a list that are shown
CONE_COLUMNS = {"name": ("cone", 1), "azimuth_rad": ("azimuth deg", 180 / np.pi), "journal_angle_rad": ("journal deg", 180 / np.pi),
                "offset_m": ("offset mm", 1e3), "skew_rad": ("skew deg", 180 / np.pi), "apex_m": ("apex mm", 1e3),
                "mass_kg": ("mass kg", 1), "axial_inertia_kg_m2": ("Ic kg m2", 1), "asymmetry": ("(It1 - It2)/Ic", 1),
                "centre_off_axis_m": ("centre off axis mm", 1e3), "speed_ratio": ("speed over the bit's", 1),
                "rolling_ratio_gage_row": ("gage row rolls at", 1), "tracking_share": ("tracking", 1),
                "tracking_share_random_phase": ("at random phase", 1)}
ROW_COLUMNS = {"cone": ("cone", 1), "row": ("row", 1), "teeth": ("teeth", 1), "gage": ("at the gage", 1),
               "tip_cone_radius_m": ("tip from journal mm", 1e3), "tip_bit_radius_m": ("tip from bit's axis mm", 1e3),
               "tip_height_m": ("height mm", 1e3), "reach_m": ("reach mm", 1e3), "rolling_ratio": ("rolling ratio", 1),
               "prints_per_revolution": ("prints/rev", 1), "print_width_m": ("print mm", 1e3), "tooth_contact_ratio": ("contact ratio", 1),
               "tracking_share": ("tracking", 1), "tracking_share_random_phase": ("at random phase", 1)}
ASSUMPTION_COLUMNS = {"cone": ("cone", 1), "unbalance_force_N": ("unbalance N", 1), "unbalance_share_of_weight": ("of the weight", 1),
                      "gravity_torque_N_m": ("gravity N m", 1), "inertia_modulation_once": ("inertia, once a turn", 1),
                      "inertia_modulation_twice": ("twice a turn", 1), "cone_frequency_Hz": ("turns Hz", 1),
                      "momentum_torque_error_N_m": ("torque left out N m", 1),
                      "momentum_torque_error_over_Ic_speed2": ("over Ic phi'^2", 1), "cone_ratio": ("at the ratio", 1),
                      "bit_speed_rad_per_s": ("bit rad/s", 1)}
CUTTER_COLUMNS = {"name": ("cutter", 1), "blade": ("blade", 1), "zone": ("zone", 1), "tip_radius_m": ("r mm", 1e3),
                  "azimuth_rad": ("phi deg", 180 / np.pi), "tip_height_m": ("h mm", 1e3), "profile_angle_rad": ("profile deg", 180 / np.pi),
                  "back_rake_rad": ("back deg", 180 / np.pi), "side_rake_rad": ("side deg", 180 / np.pi), "diameter_m": ("D mm", 1e3),
                  "under_exposure_m": ("under mm", 1e3), "wear_m": ("wear mm", 1e3), "exposure_m": ("exposure mm", 1e3),
                  "overlap_with_next": ("overlap", 1), "area_m2": ("area mm2", 1e6), "volume_m3_per_rev": ("volume mm3/rev", 1e9)}
CLEARANCE_COLUMNS = {"part_a": ("part", 1), "part_b": ("and", 1), "distance_m": ("gap mm (< 0: overlap)", 1e3),
                     "angle_a_rad": ("at its cone's deg", 180 / np.pi), "angle_b_rad": ("at its cone's deg", 180 / np.pi)}


def shown(value, factor=1):
    """A number with four digits, a word as it is, a null as a dash."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if value is None:
        return "-"
    if isinstance(value, int) and factor == 1:
        return str(value)
    if isinstance(value, (int, float)):
        return f"{round(factor * value, 9) + 0.0:.4g}"  # removes rounding errors
    return str(value)


def is_plain(value):
    return value is None or isinstance(value, (bool, int, float, str))


def table(title, entries, columns, note="", folded=False):
    """A row for each entry; plain keys that `columns` does not name come last, under their own names."""
    more = [k for k in dict.fromkeys(k for e in entries for k in e)
            if k not in columns and all(is_plain(e.get(k)) for e in entries)]
    columns = {k: v for k, v in columns.items() if any(k in e for e in entries)} | {k: (k, 1) for k in more}
    return {"title": title, "note": note, "folded": folded, "heads": [head for head, _ in columns.values()],
            "rows": [[shown(e.get(k), factor) for k, (_, factor) in columns.items()] for e in entries]}


def flattened(path, value):
    """(path, text) of numbers and short lists of them, (path, list) of lists of entries, from any depth."""
    if is_plain(value):
        yield path, shown(value)
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield from flattened(f"{path}, {key}", inner)
    elif value and all(isinstance(e, dict) for e in value):
        yield path, value
    elif all(is_plain(e) for e in value):
        yield path, ", ".join(map(shown, value[:LISTED])) + (f", ... ({len(value)})" if len(value) > LISTED else "")


def leftovers(bit):
    """Keys of the bit and of its cones that the page does not know; plain keys of cones are columns of their table."""
    for key, value in bit.analysis.items():
        if key not in BIT_KEYS:
            yield from flattened(key, value)
    for cone in bit.cones:
        for key, value in cone.items():
            if key not in CONE_KEYS and not is_plain(value):
                yield from flattened(f"{cone['name']}, {key}", value)


def overlaps(analysis):
    """What the mass counts twice."""
    found = analysis.get("cutter_overlaps", {"pairs": []})
    rows = []
    if found["pairs"]:
        rows.append(("cutters that overlap", f"{len(found['pairs'])} pairs, {1e9 * found['volume_m3']:.4g} mm3"))
    if analysis.get("cutters_in_body_m3"):
        rows.append(("cutters inside the body", f"{1e9 * analysis['cutters_in_body_m3']:.5g} mm3, counted twice in the mass"))
    return rows


def body(analysis):
    """Blades and junk slots, and how near they come to the rock."""
    if "body" not in analysis:
        return []
    found = analysis["body"]
    rows = [("blades", f"exposure {1e3 * found['exposure_m']:.4g} mm, slots {1e3 * found['slot_depth_m']:.4g} mm deep, "
                       f"junk slots {1e6 * found['junk_slot_area_m2']:.5g} mm2")]
    if found.get("stands_proud_m"):
        rows.append(("blades stand proud of the cutters by", f"{1e3 * found['stands_proud_m']:.4g} mm: they rub at any depth of cut"))
    if found.get("least_axial_clearance_m") is not None:
        rows.append(("blades clear the rock by", f"{1e3 * found['least_axial_clearance_m']:.4g} mm along the axis"))
    if found.get("touches_at_m_per_rev") is not None:
        rows.append(("blades touch it from", f"{1e3 * found['touches_at_m_per_rev']:.4g} mm a revolution on"))
    return rows


def balance(analysis):
    """Side forces over the weight of the planar model, and its normal and drag parts."""
    found = analysis.get("balance")
    if not found:
        return []

    def towards(key):
        vector = found[f"{key}_vector_over_weight"]
        return f"{100 * found[f'{key}_over_weight']:.2f} % of the weight, towards {np.degrees(np.arctan2(vector[1], vector[0])) + 0.0:.0f} deg"

    ratio = found["normal_over_drag_force"]
    return [("imbalance of the planar model (Warren and Sinor 1986)", f"{towards('planar')}; compare layouts by this value"),
            ("its normal part: pushes along the profile's normals", towards("normal_part")),
            (f"its drag part: pushes against the motion, normal over drag force {ratio:g}", towards("drag_part"))]


def numbers(bit):
    a = bit.analysis
    centre = ", ".join(f"{1e3 * x:.3f}" for x in a["centre_m"])
    inertia = "; ".join(" ".join(f"{x:.5g}" for x in row) for row in a["inertia_kg_m2"])
    rows = [("gage diameter", f"{2e3 * a['gage_radius_m']:.3f} mm"), ("parts, triangles", f"{len(bit.parts)}, {len(bit.triangles)}"),
            ("mass", f"{a['mass_kg']:.3f} kg"), ("centre of mass, bit frame", f"({centre}) mm"),
            ("inertia about it, rows", f"{inertia} kg m2")]
    if bit.cutters:
        lateral = a["imbalance_vector_of_unit_law"]
        rows += [("penetration", f"{1e3 * a['penetration_m_per_rev']:.4g} mm a revolution"),
                 ("cutters that cut at each radius, mean by area", f"{a['mean_redundancy']:.3f}"),
                 ("imbalance of the unit law", f"{100 * a['imbalance_of_unit_law']:.3f} % of all pushes, towards "
                  f"{np.degrees(np.arctan2(lateral[1], lateral[0])):.1f} deg")]
        rows += balance(a)
    rows += overlaps(a) + body(a) + [(path, value) for path, value in leftovers(bit) if isinstance(value, str)]
    return {"title": "In numbers", "note": "", "folded": False, "heads": [], "rows": rows}


def kinds(bit):
    """Parts by kind."""
    counted = {}
    for p in bit.parts:
        entry = counted.setdefault(p["kind"], {"kind": p["kind"], "parts": 0, "cutting": 0, "volume": 0.0, "mass": 0.0})
        entry["parts"] += 1
        entry["cutting"] += bool(p["cuts"])
        entry["volume"] += 1e6 * p["volume_m3"]
        entry["mass"] += p["volume_m3"] * p["density_kg_m3"]
    return table("Parts by kind", list(counted.values()), {"kind": ("kind", 1), "parts": ("parts", 1), "cutting": ("that cut", 1),
                                                          "volume": ("volume cm3", 1), "mass": ("mass kg", 1)})


def blades(bit):
    entries = []
    volume = bit.column("volume_m3_per_rev").sum()
    for blade in sorted({c["blade"] for c in bit.cutters}):
        own = [c for c in bit.cutters if c["blade"] == blade]
        entries.append({"blade": blade, "cutters": len(own), "area": 1e6 * sum(c["area_m2"] for c in own),
                        "share": 100 * sum(c["volume_m3_per_rev"] for c in own) / volume})
    return table("Blades", entries, {"blade": ("blade", 1), "cutters": ("cutters", 1), "area": ("cut area mm2", 1),
                                     "share": ("share of the volume %", 1)})


def cone_tables(bit):
    rows = [{"cone": c["name"], "row": j + 1, **row} for c in bit.cones for j, row in enumerate(c["rows"])]
    note = ("The equations of motion take a cone's transverse inertias as equal and its centre on its axis (thesis: 5.1): these are "
            "the numbers of that assumption.")
    worth = [{"cone": c["name"], **c["assumptions"]} for c in bit.cones if "assumptions" in c]
    return [table("Cones", bit.cones, CONE_COLUMNS, note), table("Rows of teeth", rows, ROW_COLUMNS),
            table("What these assumptions are worth", worth, ASSUMPTION_COLUMNS,
                  "First order in the asymmetry and in the centre's distance from the axis; bearings without friction are not judged."),
            table("Gaps between cones", bit.analysis.get("clearances", []), CLEARANCE_COLUMNS,
                  "In full turns of both cones; parts stand for all that turn with them.")]


def tables(bit):
    found = [numbers(bit), kinds(bit)]
    if bit.cutters:
        found += [blades(bit), table("Cutters", bit.cutters, CUTTER_COLUMNS, folded=True)]
    if bit.cones:
        found += cone_tables(bit)
    pairs = bit.analysis.get("cutter_overlaps", {"pairs": []})["pairs"]
    if pairs:
        found.append(table("Cutters that overlap", pairs, {"volume_m3": ("volume mm3", 1e9)}, folded=True))
    return found + [table(path, entries, {}, folded=True) for path, entries in leftovers(bit) if not isinstance(entries, str)]
