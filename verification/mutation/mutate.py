"""scripts/mutate: seeds faults in a module and counts those that its tests detect (README.md)."""

import sys
import tempfile

import arguments
import equivalents
import mutants
import results
import modules
import tests
from build import Broken, Build
from judge import judge
from modules import ROOT


def drawn(module, chosen):
    """All mutants of the module in the order of the draw; with --only those of the chosen sources."""
    found = [m for f in modules.sources(module) for m in mutants.of_source(f, (ROOT / f).read_text(encoding="utf-8"))]
    found = [m for m in found if chosen.only in m.file or chosen.only == f"{m.file}:{m.line}"]
    if not found:
        raise arguments.Wrong(f"--only: found {chosen.only}, expected a part of the path of a source in src/{module}")
    return mutants.drawn(found, chosen.seed)


def row_of(module, m, record):
    return {"module": module, "function": m.function, "file": m.file, "line": m.line, "operator": m.operator, "verdict": record["verdict"], "killer": record["killer"],
            "seconds": record["seconds"], "before": m.before.strip(), "after": m.after.strip()}


def verdict_of(m, known, cache):
    """The record of a mutant: from equivalent.toml, from the cache, or from a run of the tests."""
    reason = known["judged"].get(equivalents.key(m))
    if reason:
        return {"verdict": "equivalent", "killer": "", "seconds": 0.0}
    key = (results.of_file(ROOT / m.file), m.file, m.line, m.after)
    record = cache.find(key, known["tests"])
    if record is None:
        text = (ROOT / m.file).read_text(encoding="utf-8")
        first = known["killers"].get((m.function, m.before.strip(), m.after.strip()), "")
        record = {**judge(m, known["build"], known["seconds"], known["programs"], text, first), "tests": known["tests"]}
        cache.add(key, record)
    return record


def sample(module, chosen, build, cache, judged):
    """Rows of the module's sample: `count` mutants that ran or are known to be equivalent, and those that the compiler rejected."""
    programs = modules.programs_of(module, chosen.home)
    known = {"build": build, "judged": judged, "programs": programs, "tests": results.of_tests(sum(programs, []), chosen.longest),
             "seconds": tests.Seconds(build, chosen.longest), "killers": results.killers(chosen.table)}
    rows, counted = [], 0
    for m in drawn(module, chosen):
        record = verdict_of(m, known, cache)
        if record["verdict"] == "same code":
            continue
        rows.append(row_of(module, m, record))
        counted += record["verdict"] != "compiler"
        print_verdict(m, record)
        if counted == chosen.count:
            break
    return rows


def print_verdict(m, record):
    print(f"{record['verdict']:10} {record['seconds']:6.1f} s  {m.file}:{m.line}  {m.operator}  {record['killer']}", flush=True)
    if record["verdict"] == "survived":
        print(f"  - {m.before.strip()}\n  + {m.after.strip()}", flush=True)


def check_list():
    """Prints the entries of equivalent.toml that match no mutant any more."""
    problems = equivalents.stale(equivalents.read())
    for problem in problems:
        print(f"equivalent.toml: {problem}")
    print(f"equivalent.toml: {len(problems)} stale entries")
    return 1 if problems else 0


def run(chosen):
    arguments.require_tools()
    check_list()
    judged, lines = equivalents.read(), []
    (chosen.build / "mutants").mkdir(exist_ok=True) if chosen.build.is_dir() else None
    with tempfile.TemporaryDirectory(prefix="tdbd-mutate-") as work:
        build = Build(chosen.build, work)
        cache = results.Cache(chosen.build / "mutants.jsonl")
        for module in chosen.modules:
            rows = sample(module, chosen, build, cache, judged)
            lines.append(results.score_line(module, rows))
            if chosen.table:
                results.write_table(chosen.table, module, rows)
    print("\n".join(lines))
    return 0


def main(words):
    try:
        chosen = arguments.parse(words)
        if chosen.targets:
            print(*modules.targets(chosen.modules, chosen.home))
            return 0
        return check_list() if chosen.check else run(chosen)
    except (arguments.Wrong, Broken, ValueError) as wrong:
        return arguments.fail(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
