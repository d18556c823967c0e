"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv

ERRORS = ["1e-3", "1e-6", "1e-9"]
GIVEN = ["the 50-digit", "at a tolerance of 1e-9", "a factor of sqrt(2), tolerances", "|R - R_ref|_F / sqrt(2)",
         "to errors of 1e-3, 1e-6 and 1e-9"]


def evaluations_and_us(cell):
    """Of a cell like "596 (30.4)"."""
    return [float(word.strip("()")) for word in cell.split()]


def least_over_gsl():
    """Torque evaluations and time of the fastest composition of split over those of GSL, for each error."""
    work = read_csv(Path(__file__).parent / "work.csv")
    names = work["torque evaluations (us) to"]
    for error in ERRORS:
        cells = [evaluations_and_us(c) if c[0].isdigit() else None for c in work[error]]
        gsl = cells[names.index("GSL rk8pd")]
        best = min((c for name, c in zip(names, cells) if name.startswith("TDBD split order")), key=lambda c: c[1])
        yield [a / b for a, b in zip(best, gsl)]


def stated():
    evaluations, times = zip(*least_over_gsl())
    yield "take {:.2f}, {:.2f} and {:.2f} times as long as GSL", *times
    yield "with {:.2f}, {:.2f} and {:.2f} times the evaluations", *evaluations
