"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv

CONTINUES = "`bit-b-continues`, 20 rows"
COARSE_STEPS = "`bit-c-steady`, 60 m/h in steps of 5 ms, 2 mm, 4 revolutions, 4 rows"
GIVEN = ["in steps of 5 ms at 2 mm edges"]


def stated():
    now = read_csv(Path(__file__).parent / "now.csv")
    row = {case: {column: values[i] for column, values in now.items()} for i, case in enumerate(now["case"])}
    others = [r["pairs at most"] for case, r in row.items() if case not in (CONTINUES, COARSE_STEPS)]
    yield "ends with {:.0f} pairs, and", row[COARSE_STEPS]["pairs at the end"]
    yield "has up to {:.0f} on its way", row[CONTINUES]["pairs at most"]
    yield "other cases of the table have {:.0f} at every look", max(others)
    yield "has a quality of {:.3f}", min(now["worst triangle"])
    yield "takes up to {:.1f} us a touched", row[CONTINUES]["us a touched triangle at most"]
