"""The command `tdbd curve` as a user meets it: curve_command.py TDBD FOLDER.

Bit B under a sharp law of Detournay, whose rate is known: W = zeta eps b d, with d the advance per revolution and b the width of
the bit, in which each cutter counts with the cosine of its profile angle. b follows from the weight of the model of Warren and
Sinor (verification/literature/drag/plane/warren_sinor_test.cpp): 15589.9 N at 2.08333 mm, 100 MPa and 0.8."""

import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys

CASES = pathlib.Path(__file__).resolve().parents[3] / "cases"
TDBD, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
EPS, ZETA, RADIUS, TURNS = 100e6, 0.7, 0.5 * 0.2159, 2.0  # Pa, 1, m, revolutions per s
WIDTH = 15589.9 / (0.8 * 100e6 * 2.08333e-3)  # m
COARSE = ["--set", "rock.edge_length=6 mm", "--set", "time.step=2 ms", "--set", "time.duration=2 s"]


def tdbd(*words):
    return subprocess.run([TDBD, *map(str, words)], capture_output=True, text=True, timeout=300)


def expect(code, words, *messages):
    done = tdbd(*words)
    assert done.returncode == code, (words, done)
    for message in messages:
        assert message in done.stdout + done.stderr, (words, message, done)
    return done


def sharp_case():
    """drill-bit-b with the law of a sharp bit."""
    text = (CASES / "drill-bit-b.toml").read_text().replace('"bits/', f'"{CASES}/bits/')
    head = text[:text.index("[forces]")]
    path = FOLDER / "sharp.toml"
    path.write_text(head + f'[forces]\nlaw = "detournay"\neps = {EPS}\nzeta = {ZETA}\n[output]\nmeans_from = "1 s"\n')
    return path


def rows_of(folder, name="curve.csv"):
    return list(csv.DictReader((folder / name).open()))


def rate_of(weight):
    """m/h"""
    return weight / (ZETA * EPS * WIDTH) * TURNS * 3600


def check_refusals(case):
    weights = ["--weights", "10kN"]
    expect(2, ["curve", case], "found neither --weights nor --rate, expected --weights 10,20,30kN for a curve")
    for wrong in ("10,20", "10m,20m", "-1kN", "kN", "10,,20kN", "1e999kN"):
        expect(2, ["curve", case, f"--weights={wrong}"], "--weights: found '", "expected values > 0 with a unit, such as 10,20,30 kN")
    for wrong in ("15", "15 s", "-1 m/h"):
        expect(2, ["curve", case, f"--rate={wrong}"], f"--rate: found '{wrong}', expected a rate > 0 with its unit")
    expect(2, ["curve", case, *weights, "--rocks", "shale"], '--rocks: found the rock "shale", expected one of "berea-sandstone"')
    expect(2, ["curve", case, *weights, "--strengths", "60,60MPa"], "found 60 MPa twice, expected each rock once")
    expect(2, ["curve", case, *weights, "--strengths", "60"], "--strengths: found '60', expected values > 0 with a unit, such as 60,100 MPa")
    expect(2, ["curve", case, *weights, "--tolerance", "0"], "--tolerance: found 0, expected")
    expect(2, ["curve", CASES / "bit-b-6000psi.toml", *weights], "motion: found a prescribed motion, expected kind = \"drilling\"")
    expect(2, ["curve", CASES / "string-drill-bit-b.toml", *weights], "motion: found a bit that is lowered at a rate, expected")
    expect(2, ["curve", CASES / "slow-top.toml", *weights], "found a body to rotate", "try: tdbd rotate")
    mine = FOLDER / "mine"
    mine.mkdir()
    (mine / "file").write_text("mine")
    expect(2, ["curve", case, *weights, "-o", mine], "which no curve wrote")
    assert [f.name for f in mine.iterdir()] == ["file"]


def check_rate(case):
    """The found weight is that of the law, and a run at this weight has the rate that the table states, bit for bit."""
    out = FOLDER / "rate"
    words = ["curve", case, *COARSE, "--weights", "10,20kN", "--rate", "15m/h", "-o", out, "--threads", "2"]
    done = expect(0, words, "rock of the case: 15 m/h takes ", "table in ")
    lines = [line for line in done.stdout.splitlines() if line.startswith("rock ") and ": " not in line]
    ends = {len(line.removesuffix("not steady").rstrip()) for line in lines}
    assert len(ends) == 1, done.stdout  # aligned
    rows = rows_of(out)
    assert [float(r["weight_set_n"]) for r in rows[:1]] == [10000.0]
    for row in rows:
        law = rate_of(float(row["wob_mean_n"]))
        assert abs(float(row["rop_mean_m_per_h"]) / law - 1) < 0.05, (row, law)
    [found] = rows_of(out, "rates.csv")
    assert found["result"] == "found" and abs(float(found["rop_mean_m_per_h"]) / 15 - 1) <= 0.02, found
    run = FOLDER / "again"
    weight = found["weight_set_n"]
    expect(0, ["run", case, *COARSE, "--set", f"motion.weight_on_bit={weight}", "-o", run, "--quiet"])
    summary = json.loads((run / "summary.json").read_text())
    assert 3600 * summary["rop_mean_m_per_s"] == float(found["rop_mean_m_per_h"]), (summary["rop_mean_m_per_s"], found)
    torque = 0.5 * EPS * RADIUS**2 * summary["rop_mean_m_per_s"] / TURNS
    assert abs(summary["tob_mean_n_m"] / torque - 1) < 0.03, (summary["tob_mean_n_m"], torque)

    before = (out / "curve.csv").read_bytes()
    journal = out / "curve.points" / "1-of-1" / "points.jsonl"
    lines = journal.read_bytes()
    expect(0, words, "15 m/h takes ")  # nothing is run again
    assert (out / "curve.csv").read_bytes() == before and journal.read_bytes() == lines
    one = FOLDER / "one"
    expect(0, [*words[:words.index("-o")], "-o", one, "--quiet"])
    assert (one / "curve.csv").read_bytes() == before
    return out


def check_reach(case, out):
    """Too few runs: the largest rate that was found is stated, and the exit code is 1."""
    done = expect(1, ["curve", case, *COARSE, "--weights", "10,20kN", "--rate", "90m/h", "--runs", "1", "-o", out],
                  "rock of the case: 90 m/h is out of reach; the largest rate found is ", " at 50 kN, the smallest ")
    assert math.isnan(float(rows_of(out, "rates.csv")[0]["weight_set_n"])), done


def check_rocks(case, out):
    """A law that ignores strength has one curve, with a warning; one that does not needs more weight in the stronger rock."""
    words = ["curve", case, *COARSE, "--weights", "10kN", "--strengths", "60,100MPa", "--set", "rock.dip_azimuth=45", "-o", out]
    first = expect(0, words, "warning: the force law of the cutters ignores the strength of the rock: the curves of the rocks hardly differ")
    assert first.stderr.count("rock.dip_azimuth: 45 without a unit is 45 rad; did you mean \"45 deg\"") == 1, first.stderr
    again = expect(0, [*words, "--quiet"],
                   "warning: the force law of the cutters ignores the strength of the rock")
    assert again.stdout == "", again
    rates = [float(r["rop_mean_m_per_h"]) for r in rows_of(out)]
    assert len(rates) == 2 and abs(rates[1] / rates[0] - 1) < 0.01, rates  # gage pads know the strength
    shipped = CASES / "drill-bit-b.toml"
    expect(0, ["curve", shipped, *COARSE, "--weights", "25 kN", "--rocks", "mancos-shale,berea-sandstone", "--strengths", "200MPa",
               "-o", FOLDER / "rocks", "--threads", "2"])
    rows = {r["rock"]: float(r["rop_mean_m_per_h"]) for r in rows_of(FOLDER / "rocks")}
    assert list(rows) == ["mancos-shale", "berea-sandstone", "200 MPa"]
    assert rows["200 MPa"] < 0.7 * rows["mancos-shale"], rows


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    case = sharp_case()
    check_refusals(case)
    out = check_rate(case)
    check_reach(case, out)
    check_rocks(case, FOLDER / "strengths")
    print("curve_command: all as it should be")


if __name__ == "__main__":
    main()
