"""The pictures of every kind of result that `tdbd` writes, for draw.py and the report page of a result."""

import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import result_kind
import run_pictures
from figures import calibration_pictures, convergence, rotation_pictures, style, work_precision

DRAWN = ("run", "rotation", "string", "convergence", "calibration", "curve")


@dataclass(frozen=True)
class Picture:
    """A picture that has not been drawn yet: file name without ending, heading, caption, function that returns the figure."""

    name: str
    title: str
    caption: str
    draw: Callable


def rotation(folder, summary):
    words = f"{summary.get('title') or 'rotation'}: {summary['steps']} steps of {summary['step_s']:.4g} s, order {summary['integrator']['order']}"
    return [Picture("motion", "How the body turns", "Angular velocity in the frame of the body, spins of its cones, and its third axis in space.",
                    lambda: rotation_pictures.motion(folder, words)),
            Picture("path", "The path of the third axis", "Seen along the vertical.", lambda: rotation_pictures.path(folder, words)),
            Picture("conservation", "What is conserved", "Energies, and relative changes of the total energy and of the vertical momentum. Without "
                    "applied torques the exact motion changes neither.", lambda: rotation_pictures.conservation(folder, words))]


def convergence_study(folder, study):
    made = [Picture("convergence", "Orders of convergence", "Errors over the quantity that was refined, both axes logarithmic. The legend has the "
                    "observed orders.", lambda: convergence.draw_folder(folder))]
    if work_precision.evaluations(study):
        made.append(Picture("work_precision", "Work and precision", "Error over the number of torque evaluations. Dashed: the slope of the nominal order.",
                            lambda: work_precision.of_studies([folder])))
    return made


def calibration(folder, found):
    title = found.get("title") or folder.resolve().name
    all_pictures = [Picture("coefficients", "Coefficients", "Bars: intervals of the fitted coefficients over their values.",
                            lambda: calibration_pictures.coefficients(folder, title)),
                    Picture("predictions", "Computed and measured loads", "Bars: intervals of a reading. On the grey line both are equal.",
                            lambda: calibration_pictures.predictions(folder, title))]
    has_fit = bool(calibration_pictures.rows_of(found))
    return all_pictures if has_fit else all_pictures[1:]


def string(folder, _):
    from figures import string_pictures  # here: pyplot, which the other pictures do not need

    figures, _ = string_pictures.pictures(folder)
    titles = {"torque_and_drag": "Torque and drag", "broomstick": "Hook load while running in", "modes": "Free vibrations",
              "traces": "Traces", "time_depth": "Along the string over time"}
    return [Picture(name, titles.get(name, name), "", lambda figure=figure: figure) for name, figure in figures.items()]


def curve_of_rates(folder):
    import curve  # here: pyplot, which the other pictures do not need

    rows = curve.read_rows(folder / "curve.csv")
    return {"curve": rows, "rates": curve.rates(folder)}, [
        Picture("curve", "Rate and torque over the weight on bit", "Bars: intervals of the means (95 %). Stars: weights that were found for the rate.",
                lambda: curve.figure_of(folder))]


SWEEP_PICTURES = {"curves": ("Results over the factor", ""), "map": ("Maps", "Dots: the points. Colours: the value at the nearest point."),
                  "effects": ("Main effects", "All points, and the mean of each value of a factor. Numbers: the share of the variance that the "
                              "factor explains, or for samples the standardised coefficient of a linear fit."),
                  "parallel": ("Parallel coordinates", "A line for each point, through its factors and results.")}


def study(path):
    """(summary, pictures) of the table of a sweep, in the units of the trade."""
    import sweep  # here: pyplot, which the other pictures do not need
    import sweep_table

    try:
        table = sweep_table.in_drawn_table(sweep_table.read_table(path))
    except (OSError, KeyError, IndexError, AttributeError) as error:
        raise result_kind.NoResult(f"{path}: found no table of a sweep ({error}), expected NAME.nc of tdbd sweep") from error
    if not table.factors or not table.figures or table.front.size == 0:
        raise result_kind.NoResult(f"{path}: found no point that is done, expected at least one")
    columns = [*table.factors, *table.figures]
    cells = [[c.words[int(v)] if c.words else float(v) for v in c.values] for c in columns]
    ranges = {"factors": table.factors, "figures": table.figures}
    summary = {"title": table.title, "failed": table.failed, "unsteady": table.unsteady, "source": table.source,
               "heads": [c.label for c in columns] + ["not dominated"] * bool(table.front.any()),
               "points": [[*row, *[bool(front)] * bool(table.front.any())] for row, front in zip(zip(*cells), table.front)],
               **{kind: [(c.label, sweep_table.range_of(c)) for c in those] for kind, those in ranges.items()}}
    return summary, [Picture(kind, *SWEEP_PICTURES[kind], lambda draw=draw: draw(table)) for kind, draw in sweep.pictures(table).items()]


def of_folder(folder, kind):
    """(summary, pictures) of a result folder of one of the kinds DRAWN, or of the table of a sweep. The summaries of a curve and of a
    sweep have their tables. Raises NoResult."""
    folder = Path(folder)
    if kind == "sweep":
        return study(folder)
    if kind == "curve":
        return curve_of_rates(folder)
    file = {"convergence": "convergence.json", "calibration": "calibration.json"}.get(kind, "summary.json")
    summary = result_kind.read(folder / file)
    if kind == "run":
        return summary, [Picture(*words) for words in run_pictures.pictures(folder, summary)]
    made = {"rotation": rotation, "string": string, "convergence": convergence_study, "calibration": calibration}[kind]
    return summary, made(folder, summary)


def sign(figure, summary):
    """The program and the case behind the numbers, in small print."""
    origin = f"tdbd {summary.get('version', '?')} {summary.get('commit', '?')}"
    figure.text(0.995, 0.005, f"{origin}, case {str(summary.get('case_hash', '?'))[:12]}", ha="right", va="bottom", fontsize=6, color="0.5")
    if (engine := figure.get_layout_engine()) is not None:
        engine.set(rect=(0.0, 0.025, 1.0, 0.975))  # the signature is below


def save(picture, summary, path):
    """Draws and saves a picture, whole or not at all; the file does not depend on the date."""
    figure = picture.draw()
    sign(figure, summary)
    partial = path.with_name(f".{path.stem}.partial{path.suffix}")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of a layout that has no room
        figure.savefig(partial, dpi=style.DPI, metadata={"Software": None})
    os.replace(partial, path)
