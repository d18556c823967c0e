"""compare_tool.py PROGRAM CASES: compares models on a coarse case, twice to the byte, and refuses bad input."""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import xarray

PROGRAM, CASES = sys.argv[1], pathlib.Path(sys.argv[2])
COARSE = ["--set", "rock.edge_length=3 mm", "--set", "time.step=4 ms", "--set", "time.revolutions=2",
          "--models", "all"]


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def compare(folder, *more):
    done = run(CASES / "bit-b.toml", "-o", folder, *COARSE, *more)
    assert done.returncode == 0, done
    return {f.name: f.read_bytes() for f in pathlib.Path(folder).iterdir()}


def check_files(folder):
    """All files say the same; the blanks of one are the NaNs of another."""
    rows = list(csv.DictReader(open(folder / "comparison.csv", encoding="utf-8")))
    with xarray.open_dataset(folder / "comparison.nc") as data:
        for row in rows:
            value = float(data[row["quantity"]].sel(model=row["model"]))
            assert row["value"] == "" or float(row["value"]) == value, row
            assert (row["value"] == "") == (value != value) == (row["reason"] != ""), row
            assert data[row["quantity"]].attrs["units"] == row["unit"], row
    told = json.loads((folder / "comparison.json").read_text(encoding="utf-8"))
    assert [m["name"] for m in told["models"]] == list(dict.fromkeys(r["model"] for r in rows))
    for model in told["models"]:
        assert len(model["says"]) + len(model["cannot_say"]) == len(told["units"]), model


def check_same_bytes(folder):
    first, second = compare(folder / "1"), compare(folder / "2", "--threads", "2")
    assert first.keys() == second.keys() and len(first) == 6, first.keys()
    different = {name for name in first if first[name] != second[name]}
    assert different <= {"timing.json"}, different


def check_refusals(folder):
    assert run("--help").returncode == 0 and "compare.circle" not in run("--help").stdout
    keys = CASES.parents[1] / "reference" / "compare" / "KEYS.md"
    assert run("--keys").stdout == keys.read_text(encoding="utf-8"), "tdbd-compare --keys > reference/compare/KEYS.md"
    case = CASES / "bit-b.toml"
    cones, table = CASES / "bit-r.toml", folder / "falling.csv"
    table.write_text("depth [mm], force [kN], crater_radius [mm]\n0,0,0\n1,5,2\n2,4,3\n", encoding="utf-8")
    for arguments, reason in (((), "case file"), ((CASES / "none.toml",), "none.toml"),
                              ((case, "--models", "warren"), "'warren'"),
                              ((case, "--set", "compare.circle=1 furlong"), "compare.circle"),
                              ((case, "--set", "motion.kind=legs"), "motion"),
                              ((CASES / "bit-b-free.toml", "--models", "behr"), "Behr et al.: found motion.kind"),
                              ((case, "-o", folder / "1"), "not empty"), ((case, "--threads", "0"), "--threads"),
                              ((case, "--models", "ma-azar"), "Ma and Azar: found a bit without cones"),
                              ((cones, "--models", "warren-sinor"), "Warren and Sinor: found a bit with cones"),
                              ((cones, "--models", "ma-zhou-deng"), "Ma, Zhou and Deng: found no weight"),
                              ((cones, "--models", "huang-cawthorne-2", "--set", "compare.weight_on_bit=2e4", "--set",
                                f"compare.roller.tooth_table={table}"), "falling.csv:4: force")):
        result = run(*arguments)
        assert result.returncode == 2 and reason in result.stderr, (arguments, result)
        assert result.stdout == "", result
    assert len(list((folder / "1").iterdir())) == 6


with tempfile.TemporaryDirectory() as name:
    check_same_bytes(pathlib.Path(name))
    check_files(pathlib.Path(name, "1"))
    check_refusals(pathlib.Path(name))
