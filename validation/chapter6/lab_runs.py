"""Runs the program for the counterparts of chapter 6 and appendix D, and reads its output."""

import csv
import json
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

VALIDATION = Path(__file__).resolve().parents[1]
CASES = VALIDATION / "cases"
LABORATORY = CASES / "laboratory.toml"
RECORDS = VALIDATION / "chapter6/records.csv"
PSI = 6894.757293168361  # Pa


class Failure(Exception):
    """The program failed or a file is not as expected. The message names it and suggests a remedy."""


@dataclass(frozen=True)
class Pairing:
    name: str  # as in the names of cases
    fitted: tuple
    withheld: str

    def words(self):
        return f"{', '.join(self.fitted)} -> {self.withheld}"


PAIRINGS = (Pairing("bc-a", ("B", "C"), "A"), Pairing("ac-b", ("A", "C"), "B"), Pairing("ab-c", ("A", "B"), "C"))
LAWS = {"hanson-hansen": "", "thin-cut": "-thin-cut"}
MODES = {"combined": "", "separate": "-separate"}


@dataclass(frozen=True)
class Program:
    """The program tdbd, the folder of its cut runs, and settings for every call (--quick: coarser cut runs)."""

    path: Path
    cuts: Path
    settings: tuple = ()
    workers: int = 2

    def call(self, *words, settings=()):
        both = [w for s in (*self.settings, *settings) for w in ("--set", s)]
        done = subprocess.run([str(self.path), *map(str, words), "--cuts", str(self.cuts), *both],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failure(f"exit code {done.returncode}: tdbd {' '.join(map(str, words))}\n{done.stderr.strip()}")

    def laboratory(self, case, output, settings=(), threads=1):
        self.call("laboratory", case, "-o", output, "--force", "--threads", threads, settings=settings)

    def calibrate(self, case, output, settings=()):
        self.call("calibrate", case, "-o", output, "--force", "--quiet", settings=settings)

    def each(self, action, subjects):
        """Applies the action to each subject, several at a time. Returns the results in the order of subjects."""
        with ThreadPoolExecutor(self.workers) as pool:
            return list(pool.map(action, subjects))


def name_of(law, pairing, mode):
    return f"lab-{pairing.name}{LAWS[law]}{MODES[mode]}"


def combinations():
    return [(law, p, mode) for law in LAWS for p in PAIRINGS for mode in MODES]


def read_json(path):
    return json.loads(Path(path).read_text(encoding="utf-8"))


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def read_rows(path):
    """Reads rows of a csv as {name without unit: value}, with numbers as numbers and "" for an empty cell."""
    with Path(path).open(newline="", encoding="utf-8") as file:
        headings, *rows = csv.reader(file)
    names = [h.split(" [")[0] for h in headings]
    return [dict(zip(names, map(number, row), strict=True)) for row in rows]


@dataclass(frozen=True)
class Result:
    """One calibration: calibration.json, and the fitted and predicted records with the computed loads."""

    law: str
    pairing: Pairing
    mode: str
    json: dict
    fitted: list
    predicted: list

    def sets(self):
        """The coefficient sets: one for all pressures, or one for each."""
        return self.json.get("by_pressure", [self.json])


def read_result(folder, law, pairing, mode):
    folder = Path(folder)
    return Result(law, pairing, mode, read_json(folder / "calibration.json"), read_rows(folder / "residuals.csv"),
                  read_rows(folder / "predictions.csv"))


def differ(found, expected, tolerance):
    """Whether two files of records contain different tests, or numbers that differ by more than rounding."""
    def same(a, b):
        if isinstance(a, float) and isinstance(b, float):
            return abs(a - b) <= tolerance * max(abs(a), abs(b))
        return a == b
    if len(found) != len(expected):
        return True
    return any(a.keys() != b.keys() or not all(same(a[k], b[k]) for k in a) for a, b in zip(found, expected))


def make_records(program, out, record):
    """Makes the laboratory's records and its loads without noise. Fails unless the stored records agree."""
    made, exact = Path(out) / "records.csv", Path(out) / "exact.csv"
    program.laboratory(LABORATORY, made, threads=program.workers)
    program.laboratory(LABORATORY, exact, ("noise.reading=1e-12", "noise.test=0", "noise.rop=0"))
    if record:
        RECORDS.write_bytes(made.read_bytes())
    tolerance = 0.1 if program.settings else 1e-6  # for coarse cut runs, or for rounding
    if differ(read_rows(made), read_rows(RECORDS), tolerance):
        raise Failure(f"{RECORDS}: not what tdbd laboratory {LABORATORY} makes; if a change of the program or of the "
                      "laboratory is the reason: validation/chapter6/make.py TDBD OUT --record")
    return made, exact


def calibrate_all(program, out, records):
    """Returns {(law, pairing's name, mode): Result} of all cases."""
    own = (f"calibration.records={records}",) if program.settings else ()  # with coarse cut runs

    def one(which):
        law, pairing, mode = which
        name = name_of(law, pairing, mode)
        program.calibrate(CASES / f"{name}.toml", Path(out) / "runs" / name, own)
        return read_result(Path(out) / "runs" / name, law, pairing, mode)
    found = program.each(one, combinations())
    return {(r.law, r.pairing.name, r.mode): r for r in found}
