#!/usr/bin/python3
"""Noise of sections and of volumes, as verify_simulation and verify_rock print it. Writes noise.csv and plane.csv beside itself,
some seconds; wants a release build.

    measure.py [--build FOLDER]
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_runs import build_folder, found, found_all, printed, write_csv  # noqa: E402

N = r"([-+]?\d+\.\d+)"
FIGURES = [("rms of one step, section: median, %", "{:.2f}"), ("rms of one step, section: worst, %", "{:.2f}"),
           ("rms of one step, volume removed: median, %", "{:.1f}"),
           ("mean of section's volume rate over volume removed: median", "{:.4f}"), ("the cutter beside the axis", "{:.4f}"),
           ("least of the others", "{:.4f}"), ("largest of the others", "{:.4f}"),
           ("the cutter beside the axis, discs of 0.2 mm instead of 2 mm", "{:.4f}")]


def noise(build):
    told = printed(build / "verification/simulation/verify_simulation", "SectionNoise.*")
    numbers = [*found(rf"section {N} % \(worst {N} %\), volume {N} %", told),
               *found(rf"median {N}, first cutter {N}, others {N} to {N}", told), *found(rf"0\.2 mm thick: {N}", told)]
    return [[what, form.format(n)] for (what, form), n in zip(FIGURES, numbers, strict=True)]


def plane(build):
    told = printed(build / "verification/rock/verify_rock", "SteadySection.comes_to_what_the_radial_plane_gives_*")
    return [[f"{edge:.2f}", f"{rms:.3f}"] for edge, rms in found_all(rf"edges {N} mm:.*; rms {N} %", told)]


def main():
    build = build_folder(__doc__)
    write_csv(HERE / "noise.csv", ["figure", "value"], *noise(build))
    write_csv(HERE / "plane.csv", ["edges, mm", "apart from the radial plane, rms, %"], *plane(build))


if __name__ == "__main__":
    main()
