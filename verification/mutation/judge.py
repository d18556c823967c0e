"""What becomes of one mutant: compiled, linked with each program in turn, and shown to the tests until one fails."""

import itertools
import time

import mutants
import scripts
import tests
from modules import CALL_TDBD
from watch import run_tests


def judge(mutant, build, seconds, programs, text, first=""):
    """A record {verdict, killer, seconds, ran, words}; verdict "same code" when the compiler makes the same of both. first: what killed it before."""
    started = time.monotonic()
    record = {"verdict": "survived", "killer": "", "ran": 0, "words": ""}
    made, complaint = build.compile(mutant.file, mutants.mutated(text, mutant))
    if made is None:
        record.update(verdict="compiler", words=complaint[:400])
    elif build.is_same_code(mutant.file, made):
        record["verdict"] = "same code"
    else:
        run_stages(record, mutant, build, seconds, programs, made, first)
    record["seconds"] = round(time.monotonic() - started, 1)
    return record


def run_stages(record, mutant, build, seconds, programs, made, first):
    own, others = scripts.of_file(mutant.file, first)
    for program, outcome in itertools.chain(run_scripts(own, mutant, build, made), run_programs(mutant, build, seconds, programs, made, first),
                                            run_scripts(others, mutant, build, made)):
        record["ran"] += outcome.ran
        if outcome.verdict != "passed":
            record.update(verdict=outcome.verdict, killer=f"{program} {outcome.test}".strip())
            return


def run_programs(mutant, build, seconds, programs, made, first):
    """(program, outcome) of each stage of its tests."""
    linked = {}
    for program, names in tests.stages(programs, mutant.file, seconds, first):
        if program not in linked:
            linked[program] = link(program, mutant, build, made)
        yield program, run_tests(linked[program], names, lambda test, p=program: tests.limit(seconds[p].get(test, 0.0)),
                                 environment(program, build), build.work)


def run_scripts(names, mutant, build, made):
    program = build.link("tdbd", mutant.file, made) if names else None
    for name in names:
        yield "verify_app", scripts.run(name, program, build.work, scripts.limits(build)[name])


def link(program, mutant, build, made):
    if program in CALL_TDBD:
        build.link("tdbd", mutant.file, made)
        if "/app/" in mutant.file:
            return build.program(program)  # its tests only call the program
    return build.link(program, mutant.file, made)


def environment(program, build):
    called = {"TDBD_PROGRAM": str(build.work / "tdbd")} if program in CALL_TDBD else {}
    return {**tests.ENVIRONMENT, **called}
