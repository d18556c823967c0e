"""tdbd bit: writes a bit that reads back, in every format, and refuses a part that is no solid."""

import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM, BIT = sys.argv[1:3]


def tdbd(*arguments):
    return subprocess.run([PROGRAM, "bit", *map(str, arguments)], capture_output=True, text=True)


def mass_line(result):
    assert result.returncode == 0, result.stderr
    return [line for line in result.stdout.splitlines() if line.startswith("mass ")]


def check_round_trip(folder, form):
    first = tdbd(BIT, "-o", folder / form, "--format", form, "--parts")
    assert "cutter-28/chamfer" in first.stdout and "gage radius 107.950 mm" in first.stdout
    for name in ("bit.toml", "bit.json", "bit.stl", "bit.vtp", "profile.csv", "cutters.csv",
                 f"parts/cutter-1/face.{form}", f"parts/bit-body.{form}"):
        assert (folder / form / name).stat().st_size > 0, name
    again = tdbd(folder / form / "bit.toml")
    assert mass_line(first) == mass_line(again) != [], (mass_line(first), mass_line(again))


def check_table(folder):
    """The table that is printed is the one that is written, in mm and degrees."""
    lines = tdbd(BIT, "--cutters").stdout.splitlines()
    first = next(k for k, line in enumerate(lines) if line.split()[:2] == ["cutter", "blade"]) + 1
    printed = [line.split() for line in lines[first:first + 28]]
    assert tdbd(BIT, "-o", folder / "table", "--quiet").returncode == 0
    with (folder / "table/cutters.csv").open(newline="") as file:
        written = list(csv.DictReader(file))
    assert len(written) == len(printed) == 28
    for row, (name, blade, zone, *numbers) in zip(written, printed, strict=True):
        assert (row["cutter"], row["blade"], row["zone"]) == (name, blade, zone), (row, name)
        for column, number in zip(("r_tip_mm", "phi_deg", "h_tip_mm", "profile_angle_deg", "back_rake_deg", "side_rake_deg", "dia_mm"), numbers,
                                  strict=True):
            assert abs(float(row[column]) - float(number)) <= 0.5001 * 10.0 ** -len(number.partition(".")[2]), (row, column, number)


def check_analysis(a):
    """Every cutter has its neighbours; the imbalance has its direction; parts come as they are made."""
    assert all(0 <= c["exposure_m"] < c["diameter_m"] for c in a["cutters"]), a["cutters"]
    assert abs(math.hypot(*a["imbalance_vector_of_unit_law"]) - a["imbalance_of_unit_law"]) < 1e-15
    assert a["imbalance_vector_of_unit_law"][2] == 0
    assert a["parts"][0]["name"] == "cutter-1/face" and a["parts"][-1]["kind"] == "bit-body"
    for c in a["cutters"]:
        tip = [c["face_centre_m"][i] - c["diameter_m"] / 2 * c["z_axis"][i] for i in range(3)]
        assert math.dist(tip, c["tip_m"]) < 1e-3, c  # but for the chamfer's depth along x
    assert a["body_profile_rz_m"][0][0] == 0 and "cones" not in a


def check_report(folder):
    """The cut volumes of the analysis fill the hole; a report needs a folder and a length."""
    ordered = tdbd(BIT, "-o", folder / "report", "--report", "--penetration", "3 mm")
    assert ordered.returncode == 0, ordered.stderr
    a = json.loads((folder / "report/analysis.json").read_text())
    assert len(a["cutters"]) == 28 and a["penetration_m_per_rev"] == 0.003, a
    hole = math.pi * a["gage_radius_m"] ** 2 * 0.003
    assert abs(sum(c["volume_m3_per_rev"] for c in a["cutters"]) / hole - 1) < 1e-3
    assert 0 < a["imbalance_of_unit_law"] < 0.2 and 1 < a["mean_redundancy"] < 28, a
    check_analysis(a)
    nowhere = tdbd(BIT, "--report")
    assert nowhere.returncode == 2 and "--report: found no folder" in nowhere.stderr, nowhere
    for wrong in ("3 s", "0 mm", "much"):
        bad = tdbd(BIT, "-o", folder / "bad", "--report", "--penetration", wrong)
        assert bad.returncode == 2 and "--penetration: found" in bad.stderr, bad


def check_facts():
    """Facts first, and no rows without an option; the output fits on a screen for every bit."""
    for bit in sorted(pathlib.Path(BIT).parent.glob("*.toml")):
        done = tdbd(bit)
        lines = done.stdout.splitlines()
        assert done.returncode == 0 and done.stderr == "" and len(lines) <= 60, (bit, done.stderr, len(lines))
        assert lines[0].endswith(" mm") and "gage radius" in lines[0] and lines[-1].startswith("to list all: "), lines
    shown = tdbd(BIT).stdout
    for words in ("28 cutters", "planar model of Warren and Sinor", "doubts about the table of cutters: none", "body: at 5.000 mm per revolution it clears"):
        assert words in shown, (words, shown)
    assert "cutter-1/face" not in shown and "359.428" not in shown, shown


def check_export(folder):
    """The exported files have the facts of the bit, without rounding errors such as -0.0 or 1e-14."""
    out = folder / "facts"
    assert tdbd(BIT, "-o", out, "--quiet").returncode == 0
    first = tdbd(BIT, "--cutters").stdout.splitlines()
    for name in ("bit.toml", "solids.toml"):
        again = tdbd(out / name, "--cutters")
        assert again.returncode == 0 and again.stderr == "", again
        lines = [line for line in again.stdout.splitlines() if "e-1" in line or "-0.0" in line.split()]
        assert lines == [], lines
        kept = ("cutters: ", "blades ", "zones ", "blades: ")
        assert [line for line in again.stdout.splitlines() if line.startswith(kept)] == [line for line in first if line.startswith(kept)], again


def check_set(folder):
    """Rakes of the shoulder are changed on the command line, and the written table makes the same bit."""
    out = folder / "set"
    done = tdbd(BIT, "--set", "adjust.zone.shoulder.back_rake=-0.4 deg", "--set", "adjust.cutter.1-7.side_rake=-15 deg", "-o", out)
    assert done.returncode == 0, done.stderr
    with (out / "cutters.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert (rows[11]["back_rake_deg"], rows[9]["back_rake_deg"], rows[6]["side_rake_deg"]) == ("14.525", "13.21", "-15"), rows
    text = re.sub('^table = .*$', 'table = "cutters.csv"', pathlib.Path(BIT).read_text(), flags=re.MULTILINE)
    (out / "again.toml").write_text(text)
    again = tdbd(out / "again.toml")
    assert mass_line(again) == mass_line(done) and again.returncode == 0, again
    wrong = tdbd(BIT, "--set", "adjust.zone.sholder.back_rake=1 deg")
    assert wrong.returncode == 2 and "--set: adjust.zone.sholder.back_rake: found no zone sholder in the bit, expected a zone" in wrong.stderr, wrong


def check_doubts(folder):
    """A sign error in one height is an error; one that may be intended is a warning."""
    bit = pathlib.Path(BIT)
    (folder / "wrong.toml").write_text(bit.read_text().replace('"bit-b.csv"', '"wrong.csv"'))
    table = bit.with_suffix(".csv").read_text()
    (folder / "wrong.csv").write_text(table.replace(",6.167,", ",-6.167,"))
    wrong = tdbd(folder / "wrong.toml")
    assert wrong.returncode == 2 and "wrong.csv:6: h_tip_mm: found -6.167 mm of cutter 5, expected about 6.17 mm (is the sign wrong?)" in wrong.stderr
    assert "slot_depth" not in wrong.stderr, wrong.stderr
    (folder / "wrong.csv").write_text(table.replace(",4.002", ",-4.002"))
    doubtful = tdbd(folder / "wrong.toml")
    assert doubtful.returncode == 0 and doubtful.stderr.startswith("tdbd: warning: ") and "wrong.csv:21: side_rake_deg" in doubtful.stderr, doubtful
    assert "doubts about the table of cutters: 1, on standard error" in doubtful.stdout


def bounds(file):
    """Largest coordinate of a text STL."""
    return max(abs(float(x)) for line in file.read_text().splitlines() if line.startswith("vertex ") for x in line.split()[1:])


def check_units(folder):
    """CAD files are in mm and say so; the bit reads back the same; another unit and binary STL."""
    out = folder / "units"
    first = tdbd(BIT, "-o", out)
    assert "wrote bit.stl in mm, parts/ in m\n" in first.stdout, first
    assert (out / "bit.stl").read_text().startswith("solid cutter-1/face unit=mm\n")
    assert 107 < bounds(out / "bit.stl") < 400, bounds(out / "bit.stl")
    assert b"comment tdbd unit m\n" in (out / "parts/bit-body.ply").read_bytes()[:200]
    bit = out / "solids.toml"
    assert 'unit = "1 mm"' in bit.read_text()
    bit.write_text(bit.read_text().replace('unit = "1 mm"\n', ""))
    assert mass_line(tdbd(bit)) == mass_line(first) != []
    bit.write_text(bit.read_text().replace('file = "bit.stl"', 'file = "bit.stl"\nunit = "1 m"'))
    wrong = tdbd(bit)
    assert wrong.returncode == 2 and "solids.unit: found 1 m, but the header of " in wrong.stderr, wrong
    assert "states the unit mm, expected the unit that the file states, or no unit" in wrong.stderr, wrong
    binary = tdbd(BIT, "-o", folder / "binary", "--binary", "--unit", "in")
    assert "wrote bit.stl in in (binary), parts/ in m\n" in binary.stdout, binary
    assert (folder / "binary/bit.stl").read_bytes().startswith(b"tdbd unit in ")
    mass, again = (float(mass_line(x)[0].split()[1]) for x in (first, tdbd(folder / "binary/solids.toml")))
    assert abs(again / mass - 1) < 1e-3, (mass, again)
    for options, words in ((("--unit", "kg"), "--unit: found 'kg'"), (("--binary", "--solids", "obj"), "--binary: found --solids obj")):
        bad = tdbd(BIT, "-o", folder / "no", *options)
        assert bad.returncode == 2 and words in bad.stderr and not (folder / "no").exists(), bad
    nowhere = tdbd(BIT, "--united")
    assert nowhere.returncode == 2 and "--united: found no folder" in nowhere.stderr, nowhere


def check_united(folder):
    """One closed solid of all parts, in text and in binary."""
    small = pathlib.Path(BIT).parent / "outside.toml"
    for options in ((), ("--binary",)):
        out = folder / f"united{len(options)}"
        done = tdbd(small, "-o", out, "--united", *options)
        assert done.returncode == 0 and "bit-united.stl in mm" in done.stdout, done
        told = subprocess.run([PROGRAM, "mesh", out / "bit-united.stl"], capture_output=True, text=True)
        assert told.returncode == 0 and len(told.stdout.splitlines()) == 2, told
        again = tdbd(small, "-o", out, "--force", "--quiet")
        assert again.returncode == 0 and not (out / "bit-united.stl").exists(), again


def check_quiet(folder):
    done = tdbd(BIT, "-o", folder / "quiet", "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", ""), done
    assert (folder / "quiet/bit.json").is_file()


def check_refusals(folder):
    old = tdbd(BIT, "-o", folder / "ply")
    assert old.returncode == 2 and "exists" in old.stderr, old
    (folder / "ply/parts/cutter-3/body.ply").unlink()
    missing = tdbd(folder / "ply/bit.toml")
    assert missing.returncode == 2 and "cutter-3/body.ply" in missing.stderr, missing
    assert "bit.toml:" in missing.stderr, missing
    assert tdbd(BIT, "-o", folder / "new", "--format", "step").returncode != 0
    assert not (folder / "new").exists()


def check_force(folder):
    """An export replaces an export, whole; never its input, or what a user put there."""
    out = folder / "report"
    assert tdbd(BIT, "-o", out, "--force", "--quiet").returncode == 0
    assert (out / "bit.toml").is_file() and not (out / "analysis.json").exists()
    own = tdbd(out / "bit.toml", "-o", out, "--force")
    assert own.returncode == 2 and f"holds the input {out / 'bit.toml'}" in own.stderr, own
    mine = folder / "mine"
    mine.mkdir()
    (mine / "bit.stl").write_text("mine")
    for words in ("holds bit.stl, and no bit.toml of TDBD beside it", "is not one that TDBD wrote"):
        refused = tdbd(BIT, "-o", mine, "--force")
        assert refused.returncode == 2 and words in refused.stderr, refused
        assert (mine / "bit.stl").read_text() == "mine"
        (mine / "bit.toml").write_text('name = "mine"')


def check_old_parts(folder):
    """Meshes of the bit before go; a file of the user's own stays."""
    out = folder / "parts-of-another"
    assert tdbd(BIT, "-o", out, "--quiet").returncode == 0
    (out / "parts/mine.ply").write_text("mine")
    small = pathlib.Path(BIT).parent / "standard.toml"
    assert tdbd(small, "-o", out, "--force", "--quiet", "--format", "off").returncode == 0
    meshes = {str(f.relative_to(out)) for f in (out / "parts").rglob("*") if f.is_file()}
    named = set(re.findall('^file = "(.*)"$', (out / "bit.toml").read_text(), re.MULTILINE))
    assert named and meshes == named | {"parts/mine.ply"}, meshes ^ named


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for form in ("ply", "off", "obj", "stl"):
        check_round_trip(folder, form)
    check_table(folder)
    check_report(folder)
    check_facts()
    check_export(folder)
    check_set(folder)
    check_doubts(folder)
    check_units(folder)
    check_united(folder)
    check_quiet(folder)
    check_refusals(folder)
    check_force(folder)
    check_old_parts(folder)
