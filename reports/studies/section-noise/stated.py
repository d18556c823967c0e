"""The numbers of README.md, from the data of this study, of step-in-parts, and from benchmarks/measured.json."""

from pathlib import Path

from benchmark_figures import measured
from study_tools import read_csv

HERE = Path(__file__).parent
PARTS = HERE.parent / "step-in-parts/parts.csv"
GIVEN = ["At 1 mm edges and 1 ms", "the side of a disc of 2 mm", "With discs of 0.2 mm", "In a run all 40 sections"]


def around():
    """The share of walks in the time of sections, after near lists."""
    parts = read_csv(PARTS)
    us = {part: float(t) for part, t in zip(parts["part of a step"], parts["after, us"]) if part.startswith("sections: ")}
    return us["sections: around them"] / sum(us.values())


def stated():
    noise = read_csv(HERE / "noise.csv")
    of = dict(zip(noise["figure"], noise["value"]))
    yield ("volumes scatter by {:.1f} % in the median, sections by {:.2f} %, at worst by {:.2f} %",
           of["rms of one step, volume removed: median, %"], of["rms of one step, section: median, %"],
           of["rms of one step, section: worst, %"])
    yield "{:.3f} times the volume in the median", of["mean of section's volume rate over volume removed: median"]
    yield "and {:.4f} to {:.4f} times for all", of["least of the others"], of["largest of the others"]
    yield "whose section is {:.3f} times its", of["the cutter beside the axis"]
    yield "the section is {:.3f} times the volume", of["the cutter beside the axis, discs of 0.2 mm instead of 2 mm"]
    yield "contact areas together take {:.0f} us", measured("benchmarks", "measures_in_a_run", "value")
    yield "section was found take {:.2f} of", around()
