"""The numbers of README.md's prose, from measured.json and from the study of the rock's size."""

from pathlib import Path

from benchmark_figures import data, measured
from study_tools import read_csv

SIZE = Path(__file__).resolve().parents[1] / "reports/studies/rock-size/memory.csv"
GIVEN = ["40 sharp discs, 13.4 mm wide and 2 mm thick, 120 rpm, 15 m/h, steps of 1 ms", "(flat top to 120 mm, side, bottom)",
         "its 64 corners at both ends", "The 40 hulls do not", "where 250 were required", "MB after 0.2 m", "the height field's at 1.0 mm", "of 0.5 mm. The median",
         "of valgrind (100 steps,", "AVX-512", "a 2.7 GHz x86-64 server, GCC 12.2, `-O3` for any x86-64, CGAL 5.5"]


def steps_of_a_turn(condition):
    return next(c["steps"] for c in data()["rivals"]["conditions"] if c["name"] == condition)


def peak_at(metres):
    return next(tenth["peak_MB"] for tenth in measured("metre", "tenths") if tenth["m"] == metres)


def stated():
    yield "a triangle takes {:.0f} bytes", *read_csv(SIZE)["bytes a triangle after 100 steps"]
    yield ("the mean is {:.2f} times the height field's at 1.0 mm, {:.2f} times in `drill-bit-b`",
           measured("rivals", "warm", "standard-1.0", "mean_over_z_map"), measured("rivals", "warm", "drill-bit-b", "mean_over_z_map"))
    yield "is {:.2f} times the {:.0f} MB after 0.2 m", measured("metre", "peak_last_over_second_tenth"), peak_at(0.2)
    yield "Warm: blocks of {:.0f} steps", steps_of_a_turn("warm")
    yield "Cold: blocks of {:.0f}, each", steps_of_a_turn("cold")
    yield "read once a step, {:.2f} us", data()["rivals"]["clock_us"]
