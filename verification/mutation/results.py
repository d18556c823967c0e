"""The verdicts: a cache of JSON lines, and a table of each draw."""

import csv
import hashlib
import json
import pathlib

from modules import ROOT, test_folders

COLUMNS = ("module", "function", "file", "line", "operator", "verdict", "killer", "seconds", "before", "after")
KILLED = ("failed", "crashed", "timed out")


def of_file(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def of_tests(programs, longest):
    """Hash of the sources of these test programs and of the limit of their tests' run time."""
    digest = hashlib.sha256(f"{programs} {longest}".encode())
    for folder in test_folders(programs):
        for file in sorted(f for f in (ROOT / "verification" / folder).rglob("*") if f.suffix in (".cpp", ".hpp", ".py")):
            digest.update(f"\0{file.relative_to(ROOT)}\0".encode() + file.read_bytes())
    return digest.hexdigest()


class Cache:
    """The verdict of a killed mutant is valid until its source changes, that of a survivor until the tests change as well."""

    def __init__(self, path):
        self.path, self.records = pathlib.Path(path), {}
        if self.path.is_file():
            for line in self.path.read_text(encoding="utf-8").splitlines():
                record = json.loads(line)
                self.records[tuple(record["key"])] = record

    def find(self, key, tests):
        record = self.records.get(key)
        return record if record and (record["verdict"] != "survived" or record["tests"] == tests) else None

    def add(self, key, record):
        self.records[key] = record
        with self.path.open("a", encoding="utf-8") as file:
            file.write(json.dumps({"key": key, **record}) + "\n")


def killers(path):
    """{(function, before, after): what killed it} of a table; empty if there is no such table yet."""
    if path is None or not pathlib.Path(path).is_file():
        return {}
    with pathlib.Path(path).open(newline="", encoding="utf-8") as file:
        return {(row["function"], row["before"], row["after"]): row["killer"] for row in csv.DictReader(file) if row["verdict"] in KILLED}


def write_table(path, module, rows):
    """Writes the table with these rows in place of the earlier ones of the module."""
    path, kept = pathlib.Path(path), []
    if path.is_file():
        with path.open(newline="", encoding="utf-8") as file:
            kept = [row for row in csv.DictReader(file) if row["module"] != module]
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(sorted(kept + rows, key=lambda r: (r["module"], r["file"], int(r["line"]), r["after"])))


def counts(rows):
    """{verdict: how many}."""
    verdicts = [row["verdict"] for row in rows]
    return {v: verdicts.count(v) for v in ("failed", "crashed", "timed out", "survived", "equivalent", "compiler")}


def score_line(module, rows):
    n = counts(rows)
    killed = sum(n[v] for v in KILLED)
    judged = killed + n["survived"]
    share = f"{100.0 * killed / judged:.1f} %" if judged else "-"
    return (f"{module:12} {killed} of {judged} killed, {share}; {n['timed out']} of them timed out, {n['crashed']} crashed; "
            f"{n['survived']} survived, {n['equivalent']} equivalent, {n['compiler']} more by the compiler")
