"""tdbd bit on roller cones: bit R is what it claims, and every bad cone is refused at its place."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

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
    assert 90 <= sum(r["teeth"] for c in cones for r in c["rows"]) <= 140
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
        ([inner], ["cones[0].rows[1].protrusion: found", "> 0"]),
        ([("[\"3 mm\", \"6 mm\"]", "[\"-3 mm\", \"6 mm\"]")],
         ["cones[0].shell: found a fold: point 2", "s rising"]),
        ([("s = \"34.5 mm\"", "s = \"34.5 mm\"\nsink = \"8 mm\"")],
         ["cones[0].rows[1].protrusion: found a tip", "inside the cone"]),
        ([("s = \"57 mm\"", "s = \"36 mm\"")],
         ["cones[0].rows[2].s: found tooth", "of row 2", "do not touch"]),
        ([("s = \"82 mm\"", "s = \"820 mm\"")], ["cones[0].rows[3].s: found 820 mm"]),
        ([("offset = \"4 mm\"", "offset = \"-120 mm\"")], ["cone-1: found no place", "offset"]),
        ([("s = \"42.5 mm\"", "s = \"37 mm\"")],
         ["found an overlap of", "cone-1/row-2/tooth-1 (at", "cone-2/row-2/tooth-1 (at", " deg)"]),
        ([("spacing = [1, 1, 1.15", "spacing = [1, 1, -1.15")], ["cones[0].rows[2].spacing"]),
        ([("kind = \"conical\"", "kind = \"conicle\"")], ["did you mean conical?"]),
        ([("azimuth = \"0 deg\"", "azimuth = \"0 mm\"")], ["cones[0].azimuth"]),
        ([("name = \"bit-r\"", "name = \"bit-r\"\ntable = \"bit-b.csv\"")], ["one of the three"]),
    ]
    for replacements, words in bad:
        result = edited(folder, *replacements)
        assert result.returncode == 2, (replacements, result)
        for word in words:
            assert word in result.stderr, (word, result.stderr)
        assert "bit.toml:" in result.stderr, result.stderr


def check_report(folder):
    result = edited(folder, ("s = \"42.5 mm\"", "s = \"37 mm\""),
                    ("gage_diameter", "interference = \"report\"\ngage_diameter"))
    assert result.returncode == 0 and "between cones: an overlap" in result.stdout, result


def check_no_run(folder):
    case = folder / "case.toml"
    case.write_text(f'[bit]\nfile = "{pathlib.Path(BIT).resolve()}"\n[rock]\nedge_length = "2 mm"\n'
                    '[motion]\nrotary_speed = "60 rpm"\nrate_of_penetration = "5 m/h"\n'
                    '[time]\nstep = "1 ms"\nduration = "1 s"\n')
    result = subprocess.run([PROGRAM, "check", case], capture_output=True, text=True)
    assert result.returncode == 2 and ":2: bit.file: found a bit of 3 cones" in result.stderr, result


with tempfile.TemporaryDirectory() as name:
    check_bit_r(pathlib.Path(name))
    check_refusals(pathlib.Path(name))
    check_report(pathlib.Path(name))
    check_no_run(pathlib.Path(name))
