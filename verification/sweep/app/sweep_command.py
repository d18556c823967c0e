"""The command `tdbd sweep` as a user meets it: sweep_command.py TDBD FOLDER."""

import csv
import pathlib
import shutil
import subprocess
import sys

import xarray
from small_sweeps import ROOT, tops

CASES = ROOT / "cases"
TDBD, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
DESIGN = tops(2000, ("time.step", "values = [0.5, 1.0, 2.0]"), ("integrator.order", "values = [2, 8]"), title="six tops",
              goals=["energy_drift_max", "steps"])


def tdbd(*words):
    return subprocess.run([TDBD, *map(str, words)], capture_output=True, text=True, timeout=120)


def expect(code, words, *messages):
    done = tdbd(*words)
    assert done.returncode == code, (words, done)
    for message in messages:
        assert message in done.stdout + done.stderr, (words, message, done)
    return done


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    design, table = FOLDER / "tops.toml", FOLDER / "tops.nc"
    design.write_text(DESIGN)

    assert expect(0, ["sweep", design, "--points"]).stdout.splitlines()[1] == \
        "1: time.duration=2000; time.step=0.5; integrator.order=8"
    assert "energy_drift_max" in expect(0, ["sweep", design, "--figures", "-o", table]).stdout.split()
    assert not table.exists()
    expect(0, ["sweep", design, "-o", table, "--shard", "2/2"], "3 of 6 points are done; the last shard writes the table")
    assert not table.exists()
    expect(0, ["sweep", design, "-o", table, "--threads", "2"], "6 points done, 3 of them by an earlier call", "on the Pareto front", str(table))
    assert expect(0, ["sweep", design, "-o", table, "--quiet"]).stdout == ""

    with xarray.open_dataset(table) as data:
        assert list(data["time.step"].values) == [0.5, 0.5, 1.0, 1.0, 2.0, 2.0]
        assert (data["status"] == 0).all() and (data["steps"] * data["time.step"] == 2000).all()
        assert data.attrs["title"] == "six tops" and data.attrs["command"] == "rotate"
        assert set(data["front"].values) == {0, 1}
        rows = list(csv.DictReader(table.with_suffix(".csv").open()))
        assert [float(r["energy_drift_max"]) for r in rows] == list(data["energy_drift_max"].values)
    assert len((FOLDER / "tops_timing.csv").read_text().splitlines()) == 7

    # a point that fails is reported, and the others are kept
    (FOLDER / "one.toml").write_text(DESIGN.replace("values = [2, 8]", "values = [2, 3]").replace("values = [0.5, 1.0, 2.0]", "values = [2.0]"))
    expect(0, ["sweep", FOLDER / "one.toml", "-o", FOLDER / "one.nc"], "warning: 1 of 2 points failed, the first with: ", "integrator.order", "2 points done")
    assert expect(0, ["sweep", FOLDER / "one.toml", "-o", FOLDER / "one.nc", "--quiet"], "warning: 1 of 2 points failed, ").stdout == ""

    # what is wrong is named, and nothing is lost
    before = table.read_bytes()
    for shard in ("9/8", "0/4", "1", "1/", "1x2", "a/b", "1/2x", "-1/2"):
        expect(2, ["sweep", design, "-o", table, f"--shard={shard}"], f"--shard: found {shard}, expected I/N")
    expect(2, ["sweep", design, "-o", FOLDER / "tops.csv"], "expected a file NAME.nc")
    expect(2, ["sweep", CASES / "slow-top.toml"], "found a body to rotate", "try: tdbd rotate")
    expect(2, ["rotate", design, "-o", FOLDER / "no"], "found a sweep's design", "try: tdbd sweep")
    expect(2, ["sweep", FOLDER / "none.toml", "-o", table], "none.toml")
    other = FOLDER / "other.nc"
    other.write_bytes(b"mine")
    expect(2, ["sweep", design, "-o", other], "which no sweep wrote")
    assert other.read_bytes() == b"mine" and table.read_bytes() == before
    journal = FOLDER / "tops.points" / "1-of-1" / "points.jsonl"
    journal.write_bytes(journal.read_bytes().replace(b"figures", b"figurez", 1))
    expect(1, ["sweep", design, "-o", table], "points.jsonl:1: found a line that is not as it was written")
    assert table.read_bytes() == before
    print("sweep_command: all as it should be")


if __name__ == "__main__":
    main()
