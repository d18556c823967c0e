"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

GIVEN = ["workload for three revolutions at 1.0 mm edges", "that of 0.5 mm edges", "the 95th percentile", "With 100 steps the groove", "at edges of 1 mm",
         "with 20, the default", "the same with 20 as with 100 or 40", "power 3/2 of the edge without a rest"]
WITHOUT, DEFAULT = 0.0, 4.0  # steps of rest


def errors(row):
    """(mean, 95th percentile) of the surface, mm."""
    return [float(word) for word in row["surface error, mean and p95, mm"].split(",")]


def stated():
    by_rest = {row["rest, steps"]: row for row in read_rows(Path(__file__).parent / "rests.csv")}
    without, default = by_rest[WITHOUT], by_rest[DEFAULT]

    def share(column):
        return default[column] / without[column]

    def less(column):
        return 100.0 * (1.0 - share(column))

    larger = [100.0 * (now / then - 1.0) for now, then in zip(errors(default), errors(without), strict=True)]
    yield "leave {:.2f} of the bisections, {:.0f} % fewer", share("bisections in 1000 steps"), less("triangles at the end")
    yield "triangles and {:.0f} % fewer moves, {:.1f} of the volume disturbed", less("moves a step"), share("disturbed over removed")
    yield "a step that is {:.0f} % cheaper", less("us a plain step")
    yield "of quality {:.2f} as against {:.2f} without", default["worst quality"], without["worst quality"]
    yield "its error is {:.0f} % larger in the mean, {:.0f} % in", *larger
    yield "A maintained triangle costs {:.1f} of what it did", share("ns a touched triangle")
