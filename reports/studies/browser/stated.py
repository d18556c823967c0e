"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv, read_rows

HERE = Path(__file__).resolve().parent
GIVEN = ["within 3 s of opening", "at edges of 3 mm", "a program of at most 1 MB", "60.00000000000001 kN in place of 60 kN", "7 times was asked", "reached 5.2 times on another machine"]
SENSITIVE = "drill-bit-r"


def stated():
    size, _, picture, speed = read_csv(HERE / "cost.csv")["found"]
    yield "the picture comes after {:.1f} s and the program has {:.2f} MB", picture, size
    yield "drills {:.1f} times as fast as real time", speed
    rows = read_rows(HERE / "agreement.csv")
    calm, wild = ([row for row in rows if (row["case"] == SENSITIVE) is sensitive] for sensitive in (False, True))
    apart = [max(row[column] for row in some) for some in (calm, wild) for column in ("volumes apart, relative", "vertices apart, m")]
    yield "agree to {:.0e} of the largest part's volume and to {:.0e} m in", *apart[:2]
    yield "agrees to {:.0e} and {:.0e} m", *apart[2:]
