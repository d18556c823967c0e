"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv

CONTINUES = "`bit-b-continues`, 20 rows"
GIVEN = ["60 m/h", "is 1 mm in radius", "down by 8.3 mm, four", "(now 0.4 of one)", "6 of the 20 runs still", "because three edges form", "up to 20 mm high", "by 2 L_min"]


def stated():
    folder = Path(__file__).parent
    now, core = read_csv(folder / "now.csv"), read_csv(folder / "core.csv")
    row = {case: {column: values[i] for column, values in now.items()} for i, case in enumerate(now["case"])}
    others = [r["pairs at most"] for case, r in row.items() if case != CONTINUES]
    ends = [pairs for column, values in core.items() if column.startswith("at the end") for pairs in values]
    yield "has up to {:.0f} between two", row[CONTINUES]["pairs at most"]
    yield "second table have {:.0f} at every", max(others)
    yield "has a quality of {:.3f}", min(now["worst triangle"])
    yield "of {:.0f} runs of", len(ends)
    yield "m/h, {:.0f} end with", sum(pairs > 0 for pairs in ends)
    yield "takes up to {:.1f} us a touched", row[CONTINUES]["us a touched triangle at most"]
