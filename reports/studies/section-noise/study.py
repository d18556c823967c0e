"""Noise of sections and of volumes, from the output of tests."""

from study_runs import found, found_all

FIGURES = [("rms of one step, section: median, %", ".2f"), ("rms of one step, section: worst, %", ".2f"),
           ("rms of one step, volume removed: median, %", ".1f"), ("mean of section's volume rate over volume removed: median", ".4f"),
           ("the cutter beside the axis", ".4f"), ("least of the others", ".4f"), ("largest of the others", ".4f"),
           ("the cutter beside the axis, discs of 0.2 mm instead of 2 mm", ".4f")]


def measure(m):
    text = m.printed("verification/simulation/verify_simulation", "SectionNoise.*")
    numbers = [*found(r"section {n} % \(worst {n} %\), volume {n} %", text), *found("median {n}, first cutter {n}, others {n} to {n}", text),
               *found(r"0\.2 mm thick: {n}", text)]
    m.write("noise.csv", ({"figure": name, "value": format(n, form)} for (name, form), n in zip(FIGURES, numbers, strict=True)))
    text = m.printed("verification/rock/verify_rock", "SteadySection.comes_to_what_the_radial_plane_gives_*")
    m.write("plane.csv", ({"edges, mm": f"{edge:.2f}", "apart from the radial plane, rms, %": f"{rms:.3f}"}
                          for edge, rms in found_all("edges {n} mm:.*; rms {n} %", text)))
