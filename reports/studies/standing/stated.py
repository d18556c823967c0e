"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv

HERE = Path(__file__).parent
EDGES = (3.0, 2.0)  # mm
GIVEN = ["the slip speed (1 mm/s)", "for 6 s with edges of 3 and 2 mm and steps of 3 to 0.5 ms", "slower than 0.5 rad/s for 40 ms on both",
         "The depth after 6 s", "At 2 mm edges a step", "At 3 mm it is", "do not settle to 1e-9"]


def chosen(table, column, edges):
    return [value for e, value in zip(table["edges, mm"], table[column]) if e == edges]


def spread(values):
    """Percent of the least."""
    return 100.0 * (max(values) / min(values) - 1.0)


def of_sticks():
    now, before = read_csv(HERE / "sticks.csv"), read_csv(HERE / "sticks-before.csv")
    change, depth = "change of weight", "depth at 6 s, mm"
    yield ("weight changed by {:.2f} to {:.2f} of itself in every step it now changes by {:.0e} to {:.0e}",
           min(before[change]), max(before[change]), min(now[change]), max(now[change]))
    yield ("within {:.1f} % over all steps and within {:.1f} % over both meshes",
           max(spread(chosen(now, depth, e)) for e in EDGES), spread(now[depth]))
    yield "(before: {:.0f} to {:.0f} mm)", min(before[depth]), max(before[depth])
    yield "the creep within {:.0f} %", max(spread(chosen(now, "creep, mm/s", e)) for e in EDGES)


def of_the_case():
    now, before = read_csv(HERE / "case.csv"), read_csv(HERE / "case-before.csv")
    for phrase, column in (("comes out differently: {:.2f} mm/s instead of {:.2f}", "rate of penetration, mm/s"),
                           ("stuck for {:.2f} of the time instead of {:.2f}", "stuck share"),
                           ("at {:.3f} Hz instead of {:.3f}", "frequency, Hz")):
        yield phrase, *now[column], *before[column]


def of_plunges():
    table = read_csv(HERE / "plunges.csv")
    fallen, creep, solved = table["depth at 1 s, mm"], table["creep, mm/s"], zip(table["unsettled"], table["steps solved"])
    yield "falls {:.1f} to {:.1f} mm into the rock", min(fallen), max(fallen)
    yield "sinks at {:.2f} to {:.2f} mm/s", min(creep), max(creep)
    yield "changes the weight by at most {:.0e} of it", max(chosen(table, "change of weight", 2.0))
    yield "it is up to {:.0e}, in single", max(chosen(table, "change of weight", 3.0))
    yield "Up to {:.0f} % of the searches", 100.0 * max(unsettled / steps for unsettled, steps in solved)


def stated():
    yield from of_sticks()
    yield from of_the_case()
    yield from of_plunges()
