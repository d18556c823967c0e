"""The tables of the section that compares the models of chapter 2: expected and observed, numbers, what each cannot say."""

from collections.abc import Callable
from dataclasses import dataclass

from comparison_verdicts import verdicts
from study_tools import markdown_table

SHOWN = {"bit-b": "bit B", "bit-b-free": "bit B on a string", "whirl-1500": "bit B in whirl, orbit of 1.5 mm", "bit-r": "the roller cone bit", "bit-r-4": "the same, journals offset by 4 mm",
         "bit-r-8": "the same, journals offset by 8 mm"}


@dataclass(frozen=True)
class Table:
    title: str
    caption: str
    write: Callable  # results -> Markdown


def words(quantity):
    return quantity.replace("_", " ")


def middle(runs):
    """The result in the middle of a sweep."""
    return runs[len(runs) // 2][1]


def expected_and_observed(results):
    rows = [[v.expected, v.observed, v.word] for v in verdicts(results)]
    return markdown_table(["Expected, stated before the runs", "Observed", "Verdict"], rows)


def number(value):
    return "–" if value is None else f"{value:.4g}"


def numbers_of(result):
    """A row for each quantity that any model says, a column for each model; the cost last."""
    rows = [[f"{words(q)} ({unit})" if unit != "1" else words(q), *(number(result.value(m, q)) for m in result.titles)]
            for q, unit in result.quantities.items() if any(result.value(m, q) is not None for m in result.titles)]
    rows.append(["CPU time over simulated time, measured once", *(number(result.cost(m)) for m in result.titles)])
    notes = "".join(f"- {m['title']}: {note}\n" for m in result.info["models"] for note in m.get("notes", []))
    return markdown_table(["", *result.titles.values()], rows) + (f"\n{notes}" if notes else "")


def given(result):
    """What the case gives: an advance, or nothing of a bit on a string."""
    return f", {1e3 * result.advance:.3g} mm a revolution" if result.advance > 0.0 else ""


def numbers(results):
    return "\n".join(f"**{name[0].upper()}{name[1:]}**{given(middle(results[g]))}:\n\n{numbers_of(middle(results[g]))}"
                     for g, name in SHOWN.items() if g in results)


def reasons_of(result):
    """{(model's title, reason): quantities}."""
    found = {}
    for (model, quantity), reason in result.reasons.items():
        found.setdefault((result.titles[model], reason), []).append(words(quantity))
    return found


def cannot_say(results):
    found = {}
    for group in ("bit-b", "bit-r"):
        if group in results:
            for key, quantities in reasons_of(middle(results[group])).items():
                found.setdefault(key, quantities)
    rows, before = [], None
    for (title, reason), quantities in found.items():
        rows.append([title if title != before else "", ", ".join(quantities), reason])
        before = title
    return markdown_table(["Model", "Cannot say", "Because"], rows)


TABLES = {
    "expected": Table("Expected and observed",
                      "What the protocol expected was written down before any run; what came out is computed from the results. Deviations are from TDBD, unless said otherwise.",
                      expected_and_observed),
    "numbers": Table("What the models say", "A dash: the model cannot say it; the next table has the reasons.", numbers),
    "cannot-say": Table("What each model cannot say", "Quantities of tdbd-compare without a number, with the reason that the program gives.", cannot_say),
}
