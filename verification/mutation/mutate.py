"""scripts/mutate: seeds faults in a room and asks whether its tests notice. README.md says how."""

import sys
import tempfile

import arguments
import equivalents
import mutants
import results
import rooms
import tests
from build import Broken, Build
from judge import judge
from rooms import ROOT


def drawn(room, chosen):
    """All mutants of the room in the order of the draw, those of --only alone."""
    found = [m for f in rooms.sources(room) for m in mutants.of_source(f, (ROOT / f).read_text(encoding="utf-8"))]
    found = [m for m in found if chosen.only in m.file or chosen.only == f"{m.file}:{m.line}"]
    if not found:
        raise arguments.Wrong(f"--only: found {chosen.only}, expected a part of the path of a source in src/{room}")
    return mutants.drawn(found, chosen.seed)


def row_of(room, m, record):
    return {"room": room, "file": m.file, "line": m.line, "operator": m.operator, "verdict": record["verdict"], "killer": record["killer"],
            "seconds": record["seconds"], "before": m.before.strip(), "after": m.after.strip()}


def verdict_of(m, asked, cache):
    """The record of a mutant: judged by hand, known from before, or found now."""
    reason = asked["judged"].get(equivalents.key(m))
    if reason:
        return {"verdict": "equivalent", "killer": "", "seconds": 0.0}
    key = (results.of_file(ROOT / m.file), m.file, m.line, m.after)
    record = cache.find(key, asked["tests"])
    if record is None:
        text = (ROOT / m.file).read_text(encoding="utf-8")
        first = asked["killers"].get(equivalents.key(m), "")
        record = {**judge(m, asked["build"], asked["seconds"], asked["programs"], text, first), "tests": asked["tests"]}
        cache.add(key, record)
    return record


def sample(room, chosen, build, cache, judged):
    """Rows of the room's sample: `count` that ran or were judged, and beside them those that the compiler refused."""
    programs = rooms.programs_of(room, chosen.home)
    asked = {"build": build, "judged": judged, "programs": programs, "tests": results.of_tests(sum(programs, []), chosen.longest),
             "seconds": tests.Seconds(build, chosen.longest), "killers": results.killers(chosen.table)}
    rows, counted = [], 0
    for m in drawn(room, chosen):
        record = verdict_of(m, asked, cache)
        if record["verdict"] == "same code":
            continue
        rows.append(row_of(room, m, record))
        counted += record["verdict"] != "compiler"
        say(m, record)
        if counted == chosen.count:
            break
    return rows


def say(m, record):
    print(f"{record['verdict']:10} {record['seconds']:6.1f} s  {m.file}:{m.line}  {m.operator}  {record['killer']}", flush=True)
    if record["verdict"] == "survived":
        print(f"  - {m.before.strip()}\n  + {m.after.strip()}", flush=True)


def check_list():
    problems = equivalents.stale(equivalents.read())
    for problem in problems:
        print(problem)
    print(f"{len(problems)} problems")
    return 1 if problems else 0


def run(chosen):
    arguments.require_tools()
    judged, lines = equivalents.read(), []
    (chosen.build / "mutants").mkdir(exist_ok=True) if chosen.build.is_dir() else None
    with tempfile.TemporaryDirectory(prefix="tdbd-mutate-") as work:
        build = Build(chosen.build, work)
        cache = results.Cache(chosen.build / "mutants.jsonl")
        for room in chosen.rooms:
            rows = sample(room, chosen, build, cache, judged)
            lines.append(results.score_line(room, rows))
            if chosen.table:
                results.write_table(chosen.table, room, rows)
    print("\n".join(lines))
    return 0


def main(words):
    try:
        chosen = arguments.parse(words)
        if chosen.targets:
            print(*rooms.targets(chosen.rooms, chosen.home))
            return 0
        return check_list() if chosen.check else run(chosen)
    except (arguments.Wrong, Broken, ValueError) as wrong:
        return arguments.fail(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
