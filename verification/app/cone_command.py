"""tdbd bit on roller cones: bit R is what it claims, and every bad cone is refused at its place."""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy
import xarray

PROGRAM, BIT = sys.argv[1:3]
TEXT = pathlib.Path(BIT).read_text()


def tdbd(*arguments):
    return subprocess.run([PROGRAM, "bit", *map(str, arguments)], capture_output=True, text=True)


def edited(folder, *replacements):
    text = TEXT
    for old, new in replacements:
        assert old in text, old
        text = text.replace(old, new, 1)
    (folder / "bit.toml").write_text(text)
    return tdbd(folder / "bit.toml")


def check_bit_r(folder):
    result = tdbd(BIT, "-o", folder / "out")
    assert result.returncode == 0, result.stderr
    bit = json.loads((folder / "out/bit.json").read_text())
    assert abs(bit["gage_radius_m"] - 0.10795) < 1e-12, bit["gage_radius_m"]
    cones = bit["cones"]
    assert [c["name"] for c in cones] == ["cone-1", "cone-2", "cone-3"]
    assert 90 <= sum(r["teeth"] for c in cones for r in c["rows"]) <= 150
    for cone in cones:
        assert abs(math.hypot(*cone["axis"]) - 1) < 1e-12 and cone["axis"][2] > 0
        assert 0.004 < cone["axial_inertia_kg_m2"] < 0.010 and 3 < cone["mass_kg"] < 5, cone
        assert cone["asymmetry"] < 0.01 and cone["centre_off_axis_m"] < 1e-4, cone
        gage = [r for r in cone["rows"] if r["gage"]]
        assert gage and all(abs(r["reach_m"] - 0.10795) < 1e-12 for r in gage), gage
        assert all(r["reach_m"] < 0.10795 for r in cone["rows"] if not r["gage"])
    assert "an overlap" not in result.stdout and result.stdout.count("between cones: a gap") == 3
    assert b'Name="cone"' in (folder / "out/bit.vtp").read_bytes()
    assert (folder / "out/parts/cone-2/row-3/tooth-13.ply").stat().st_size > 0


def check_refusals(folder):
    """(what is changed, what the message must say)"""
    inner = ("s = \"34.5 mm\"", "s = \"34.5 mm\"\nprotrusion = \"-3 mm\"")
    bad = [
        ([inner], ["cones[0].rows[2].protrusion: found", "in (0, 10]"]),
        ([("[\"3 mm\", \"6 mm\"]", "[\"-3 mm\", \"6 mm\"]")],
         ["cones[0].shell: found a fold: point 2", "s rising"]),
        ([("s = \"34.5 mm\"", "s = \"34.5 mm\"\nsink = \"8 mm\"")],
         ["cones[0].rows[2].protrusion: found a tip", "inside the cone"]),
        ([("s = \"57 mm\"", "s = \"36 mm\"")],
         ["cones[0].rows[3].s: found tooth", "of row 3", "do not touch"]),
        ([("s = \"82 mm\"", "s = \"820 mm\"")], ["cones[0].rows[5].s: found 820 mm"]),
        ([("offset = \"4 mm\"", "offset = \"-120 mm\"")], ["bit.toml:", ": cones[0].offset: found no place"]),
        ([("s = \"42.5 mm\"", "s = \"37 mm\"")],
         ["cones[0].rows[2]: found an overlap of", "cone-1/row-3/tooth-1 (at", "cone-2/row-2/tooth-1 (at", " deg)"]),
        ([("spacing = [1, 1, 1.15", "spacing = [1, 1, -1.15")], ["cones[0].rows[3].spacing"]),
        ([("kind = \"hemispherical\"", "kind = \"hemispheric\"")], ["did you mean hemispherical?"]),
        ([("azimuth = \"0 deg\"", "azimuth = \"0 mm\"")], ["cones[0].azimuth"]),
        ([("name = \"bit-r\"", "name = \"bit-r\"\ntable = \"bit-b.csv\"")], ["one of them"]),
    ]
    for replacements, words in bad:
        result = edited(folder, *replacements)
        assert result.returncode == 2, (replacements, result)
        for word in words:
            assert word in result.stderr, (word, result.stderr)
        for line in result.stderr.strip().split("\n"):  # each at its line of the file
            assert re.search(r"bit\.toml:\d+: ", line), line


def check_coincident(folder):
    """240 degrees typed as 120: a refusal in seconds, not a search without end."""
    result = edited(folder, ('azimuth = "240 deg"', 'azimuth = "120 deg"'))
    assert result.returncode == 2 and "cone-2/" in result.stderr, result
    for words in ("found an overlap of", "expected a gap"):
        assert words in result.stderr, result.stderr


def check_report(folder):
    result = edited(folder, ("s = \"42.5 mm\"", "s = \"37 mm\""),
                    ("gage_diameter", "interference = \"report\"\ngage_diameter"))
    assert result.returncode == 0 and "between cones: an overlap" in result.stdout, result


def distance_to_side(p, a, b):
    along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / max(math.dist(a, b) ** 2, 1e-300)
    w = min(1.0, max(0.0, along))
    return math.dist(p, (a[0] + w * (b[0] - a[0]), a[1] + w * (b[1] - a[1])))


def check_analysis(folder):
    """Each row's tip lies on its section in the bit's half-plane; the cones are those of bit.json; gaps are listed."""
    done = subprocess.run([PROGRAM, "bit", BIT, "-o", folder / "analysis", "--report", "--quiet"], check=False)
    assert done.returncode == 0, done
    a, b = (json.loads((folder / "analysis" / f"{name}.json").read_text()) for name in ("analysis", "bit"))
    assert a["cutters"] == [] and a["cutters_cutting_at_radius"] == [] and a["imbalance_of_unit_law"] == 0, a.keys()
    assert "body_profile_rz_m" not in a
    for cone, same in zip(a["cones"], b["cones"], strict=True):
        assert {k: v for k, v in cone.items() if k in same and k != "rows"} == {k: v for k, v in same.items() if k != "rows"}
        for row, own in zip(cone["rows"], same["rows"], strict=True):
            assert {k: v for k, v in row.items() if k in own} == own, cone["name"]
        shell, *rows = cone["sections"]
        assert shell["part"] == "shell" and [r["part"] for r in rows] == [f"row-{j + 1}" for j in range(len(cone["rows"]))]
        for section, row in zip(rows, cone["rows"], strict=True):
            line, tip = section["meridian_rz_m"], (row["tip_bit_radius_m"], -row["tip_height_m"])
            nearest = min(distance_to_side(tip, p, q) for p, q in zip(line, line[1:] + line[:1]))
            assert nearest < 1e-9, (cone["name"], section["part"], nearest)
    assert len(a["clearances"]) == 3 and all(c["distance_m"] > 0 for c in a["clearances"]), a["clearances"]


def check_tracking(folder):
    """Tracking and contact ratios in analysis.json and on the terminal, at the requested speeds."""
    report = tdbd(BIT, "-o", folder / "report", "--report", "--cone-speeds", "1.47,1.48,1.5")
    assert report.returncode == 0 and "at random phase" in report.stdout, report
    analysis = json.loads((folder / "report/analysis.json").read_text())
    assert [c["speed_ratio"] for c in analysis["cones"]] == [1.47, 1.48, 1.5]
    rows = [r for c in analysis["cones"] for r in c["rows"]]
    assert rows[0]["tracking_share"] is None and rows[0]["tooth_contact_ratio"] == 1.0, rows[0]
    for row in rows[1:]:
        assert len(row["tracking_share_by_lag"]) == 6
        assert row["tracking_share_by_lag"][0] == row["tracking_share"]
        assert 0 <= row["tracking_share"] <= 1 and 0 < row["tracking_share_random_phase"] < 1, row
        assert 0.5 < row["tooth_contact_ratio"] < row["teeth"] / 2 and row["print_width_m"] < 0.02
    sweep = analysis["tracking"]["sweep"]
    assert len(sweep["speed_ratio"]) == len(sweep["tracking_share"]) == 161
    own = json.loads((folder / "out/bit.json").read_text())["cones"]
    default = tdbd(BIT, "-o", folder / "default", "--report")
    assert default.returncode == 0, default
    for cone, made in zip(json.loads((folder / "default/analysis.json").read_text())["cones"], own):
        gage = [r["rolling_ratio"] for r in made["rows"] if r["gage"]]
        assert [cone["speed_ratio"]] == [cone["rolling_ratio_gage_row"]] == gage
    for wrong in ("1.4", "1.4,1.4,-1", "1.4,1.4,0"):
        bad = tdbd(BIT, "-o", folder / "bad", "--report", "--cone-speeds", wrong)
        assert bad.returncode == 2 and "--cone-speeds: found" in bad.stderr, bad
        assert not (folder / "bad").exists()


def drilled(folder, name, *settings, case="bit-r-steady", more=()):
    """Summary of a short run of a shipped case, or the complaint about it."""
    case = pathlib.Path(BIT).parent.parent / f"{case}.toml"
    command = [PROGRAM, "run", case, "-o", folder / name, "--quiet", *more]
    for setting in (*settings,):
        command += ["--set", setting]
    result = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if result.returncode != 0:
        return result.stderr
    return json.loads((folder / name / "summary.json").read_text())


def check_drilling(folder):
    """Teeth of every cone cut, the ledger closes; dragged teeth cut otherwise than rolling ones."""
    rolling = drilled(folder, "rolling", "time.revolutions=1.5")
    assert rolling["volume_ledger_defect"] < 1e-12, rolling
    removed = rolling["removed_volume_by_part_m3"]
    for cone in ("cone-1", "cone-2", "cone-3"):
        teeth = [v for name, v in removed.items() if name.startswith(f"{cone}/row-3/")]
        assert sum(v > 0.0 for v in teeth) > 0.8 * len(teeth), (cone, teeth)
    dragged = drilled(folder, "dragged", "time.revolutions=1.5", "motion.cone_speeds=[0, 0, 0]")
    assert dragged["volume_ledger_defect"] < 1e-12, dragged
    still = dragged["removed_volume_by_part_m3"]
    assert sum(v > 0.0 for v in still.values()) < 0.5 * sum(v > 0.0 for v in removed.values())
    for speeds, found in (("[1.4]", "found 1 speeds"), ("rollin", "cone_speeds: found")):
        complaint = drilled(folder, "bad", f"motion.cone_speeds={speeds}")
        assert "cone_speeds" in complaint and found in complaint, complaint
        assert not (folder / "bad").exists()


def check_rolling(folder):
    """Rolling cones: near pure rolling of their gage rows, and bitwise identical with two threads."""
    short = ("time.revolutions=0.5", "rock.edge_length='4 mm'")
    first = drilled(folder, "free", *short, case="bit-r-rolling")
    again = drilled(folder, "free-2", *short, case="bit-r-rolling", more=("--threads", "2"))
    assert first == again
    for file in ("history.nc", "history.csv", "rock_final.ply", "frames/bit_final.vtp", "bit_poses.csv", "case.toml"):
        assert (folder / "free" / file).read_bytes() == (folder / "free-2" / file).read_bytes(), file
    history = xarray.open_dataset(folder / "free/history.nc", decode_times=False)
    assert dict(history["cone_angle"].sizes) == {"time": first["steps"], "cone": 3}
    assert list(history["cone_name"].values) == ["cone-1", "cone-2", "cone-3"]
    turned = history["cone_angle"].values[-1] / history["rotation_angle"].values[-1]
    speeds = history["cone_speed"].values
    numpy.testing.assert_allclose(numpy.diff(history["cone_angle"].values, axis=0),
                                  speeds[1:] * 0.002, atol=1e-12)
    for k, cone in enumerate(first["cones"]):
        assert abs(turned[k] + cone["mean_speed_ratio"]) < 1e-12
        ratios = -speeds[:, k] / (3 * math.pi)
        assert abs(ratios.min() - cone["min_speed_ratio"]) < 1e-9, cone
        assert abs(ratios.max() - cone["max_speed_ratio"]) < 1e-9, cone
        assert abs(ratios.std() - cone["std_speed_ratio"]) < 1e-9, cone
        assert 1.1 < cone["mean_speed_ratio"] < 1.7, cone
        assert abs(cone["net_slip_gage_row"]) < 0.2
    complaint = drilled(folder, "bad", "motion.cone_memory='-1 s'", case="bit-r-rolling")
    assert "motion.cone_memory: found" in complaint, complaint


with tempfile.TemporaryDirectory() as name:
    check_bit_r(pathlib.Path(name))
    check_refusals(pathlib.Path(name))
    check_coincident(pathlib.Path(name))
    check_report(pathlib.Path(name))
    check_tracking(pathlib.Path(name))
    check_drilling(pathlib.Path(name))
    check_analysis(pathlib.Path(name))
    check_rolling(pathlib.Path(name))
