"""Counterparts of figures 6.2 to 6.6 and D.1 to D.4, and more: objectives and withheld errors, the blind test."""

import sys
from dataclasses import dataclass, field

import lab_runs
from lab_runs import PAIRINGS, PSI

sys.path.insert(0, str(lab_runs.VALIDATION.parent / "reports"))
from figures import style  # noqa: E402

PRESSURE_COLOURS = (style.BLUE, style.RED)
LAW_COLOURS = {"hanson-hansen": style.BLUE, "size-effect": style.GREEN, "thin-cut": style.RED, "detournay": style.GOLD}
LOADS = {"wob": ("WOB [kN]", 1e3), "tob": ("TOB [kN m]", 1e3)}  # heading, and one of its units in SI
METRES_PER_HOUR = 1 / 3600  # m/s
SYNTHETIC = "Synthetic laboratory: a known law with noise, nothing measured."
NOT_THEIRS = "We hold the title of the thesis's figure, not its picture."


@dataclass(frozen=True)
class Figure:
    name: str
    counterpart: str  # "figure 6.3"; empty: not in the thesis
    title: str
    caption: str
    drawing: object = field(hash=False)  # a matplotlib figure


def in_psi(pressure):
    return f"{pressure / PSI:.0f} psi"


def pressures_of(rows):
    return sorted({r["pressure"] for r in rows})


def chosen(rows, bit, pressure):
    return sorted((r for r in rows if r["bit"] == bit and r["pressure"] == pressure), key=lambda r: r["rate_of_penetration"])


def rates(rows):
    return [r["rate_of_penetration"] / METRES_PER_HOUR for r in rows]


def column(rows, name, scale):
    return [r[name] / scale for r in rows]


def readings(axes, rows, load, colour, noise=0.0424):
    """Plots the laboratory's readings with two standard deviations of its noise (3 % per reading and 3 % per test)."""
    _, scale = LOADS[load]
    values = column(rows, load, scale)
    axes.errorbar(rates(rows), values, yerr=[2 * noise * v for v in values], fmt="o", color=colour, capsize=2, elinewidth=0.9)


def law_lines(axes, rows, load, colour, words):
    """Plots the law at the recorded rates as a line, and its interval of a reading."""
    _, scale = LOADS[load]
    axes.plot(rates(rows), column(rows, f"{load}_mean", scale), color=colour, label=words)
    axes.fill_between(rates(rows), column(rows, f"{load}_low", scale), column(rows, f"{load}_high", scale), color=colour, alpha=0.15,
                      linewidth=0)


def label(axes, load, rows):
    axes.set_ylabel(LOADS[load][0])
    axes.set_ylim(bottom=0)
    axes.set_xticks(sorted(set(rates(rows))))
    axes.set_xlabel("rate of penetration [m/h]")


def with_law(rows, bits):
    """One panel per load (rows) and bit (columns): readings, the law, its intervals."""
    figure, axes = style.panels(2, len(bits), (3.4 * len(bits) + 0.4, 5.0), squeeze=False, sharex=True, sharey="row")
    for j, bit in enumerate(bits):
        for i, load in enumerate(LOADS):
            for pressure, colour in zip(pressures_of(rows), PRESSURE_COLOURS):
                some = chosen(rows, bit, pressure)
                readings(axes[i, j], some, load, colour)
                law_lines(axes[i, j], some, load, colour, in_psi(pressure))
        axes[0, j].set_title(f"Bit {bit}, synthetic")
        axes[1, j].set_xlabel("rate of penetration [m/h]")
    for place, load in zip(axes[:, 0], LOADS):
        place.set_ylabel(LOADS[load][0])
        place.set_ylim(bottom=0)  # of the whole row, so after everything is drawn
    axes[0, 0].set_xticks(rates(chosen(rows, bits[0], pressures_of(rows)[0])))
    axes[0, 0].legend(loc="upper left")
    return figure


def predicted(rows, bit):
    """WOB and TOB of the withheld bit."""
    figure, axes = style.panels(1, 2, (7.2, 3.1), sharex=True)
    for place, load in zip(axes, LOADS):
        for pressure, colour in zip(pressures_of(rows), PRESSURE_COLOURS):
            some = chosen(rows, bit, pressure)
            readings(place, some, load, colour)
            law_lines(place, some, load, colour, in_psi(pressure))
        label(place, load, rows)
        place.set_title(f"Bit {bit}, withheld, synthetic")
    axes[0].legend(loc="upper left")
    return figure


def sample_record(rows, exact, bit="B"):
    """The tests of one bit as the laboratory writes them, and the loads without noise."""
    figure, axes = style.panels(1, 2, (7.2, 3.1), sharex=True)
    for place, load in zip(axes, LOADS):
        for pressure, colour in zip(pressures_of(rows), PRESSURE_COLOURS):
            some, true = chosen(rows, bit, pressure), chosen(exact, bit, pressure)
            place.plot(rates(some), column(some, load, LOADS[load][1]), "o", color=colour, label=f"read at {in_psi(pressure)}")
            place.plot(rates(true), column(true, load, LOADS[load][1]), "--", color=colour, linewidth=0.9, label="without noise")
        label(place, load, rows)
        place.set_title(f"Bit {bit}, synthetic")
    axes[0].legend(loc="upper left")
    return figure


def objectives(results):
    """Objective and withheld error of every fit of a law, which table 6.4 does not contain."""
    figure, axes = style.panels(1, 2, (7.2, 3.3))
    width, modes = 0.36, list(lab_runs.MODES)
    for i, mode in enumerate(modes):
        colour = (style.BLUE, style.SKY)[i]
        all_of = [results["hanson-hansen", p.name, mode].json for p in PAIRINGS]
        places = [k + (i - 0.5) * width for k in range(len(PAIRINGS))]
        axes[0].bar(places, [j["objective_wob"] + j["objective_tob"] for j in all_of], width, color=colour, label=mode)
        for load, marker, shift in (("wob", "o", -0.05), ("tob", "^", 0.05)):
            axes[1].plot([x + shift for x in places], [100 * j[f"withheld_bit_error_{load}_rms"] for j in all_of], marker, color=colour,
                         markersize=6, label=f"{load.upper()}, {mode}")
    for place, words in zip(axes, ("objective, WOB and TOB", "error of the withheld bit, rms [%]")):
        place.set_xticks(range(len(PAIRINGS)), [p.words() for p in PAIRINGS])
        place.set_ylabel(words)
        place.set_ylim(bottom=0)
        place.grid(visible=False, axis="x")
    axes[0].set_ylim(top=1.25 * axes[0].get_ylim()[1])
    axes[1].set_ylim(top=1.45 * axes[1].get_ylim()[1])
    axes[0].legend(loc="upper right", ncols=2)
    axes[1].legend(loc="upper right", ncols=2)
    return figure


def two_laws(results):
    """Hanson-Hansen and thin cut for the withheld bit: predicted over measured loads."""
    figure, axes = style.panels(1, 3, (7.6, 3.1), sharey=True)
    for place, p in zip(axes, PAIRINGS):
        for law, marker in (("hanson-hansen", "o"), ("thin-cut", "x")):
            rows = results[law, p.name, "combined"].predicted
            for pressure, colour in zip(pressures_of(rows), PRESSURE_COLOURS):
                some = chosen(rows, p.withheld, pressure)
                place.plot(rates(some), [r["wob_mean"] / r["wob"] for r in some], marker, color=colour, markersize=6,
                           label=f"{law}, {in_psi(pressure)}")
        place.axhline(1.0, color=style.GREY, linewidth=0.8)
        place.set_title(p.words())
        place.set_xlabel("rate of penetration [m/h]")
    axes[0].set_ylabel("WOB of the withheld bit,\ncomputed over read (synthetic)")
    axes[0].legend(loc="lower left", bbox_to_anchor=(0.0, 0.62), fontsize=7)
    axes[0].set_ylim(top=1.25 * axes[0].get_ylim()[1])
    return figure


def blind(rows):
    """Errors and coverage for every hidden law and pairing."""
    figure, axes = style.panels(1, 2, (7.6, 3.3))
    laws = list(dict.fromkeys(r["hidden law"] for r in rows))
    width = 0.8 / len(laws)
    for i, law in enumerate(laws):
        some = [r for r in rows if r["hidden law"] == law]
        places = [k + (i - (len(laws) - 1) / 2) * width for k in range(len(some))]
        axes[0].bar(places, [100 * r["p95"] for r in some], 0.9 * width, color=LAW_COLOURS[law], label=law)
        axes[1].plot(places, [r["coverage"] for r in some], "o", color=LAW_COLOURS[law], markersize=6, label=law)
    axes[0].set_ylabel("error of the withheld bit,\n95th percentile [%]")
    axes[1].set_ylabel("readings inside the 95 % intervals")
    axes[1].axhline(0.95, color=style.GREY, linewidth=0.8, linestyle="--")
    axes[1].set_ylim(0, 1.05)
    for place in axes:
        place.set_xticks(range(len(PAIRINGS)), [p.words() for p in PAIRINGS])
        place.grid(visible=False, axis="x")
    axes[0].legend(loc="upper left", title="hidden law")
    axes[0].set_ylim(top=1.35 * axes[0].get_ylim()[1])
    return figure


MARKS = "Points: readings with two standard deviations of their noise; lines: the law at the recorded rates, joined; bands: 95 % intervals of a reading. "


def fit_figure(results, name, counterpart, pairing, mode, words):
    rows = results["hanson-hansen", pairing.name, mode].fitted
    return Figure(name, counterpart, f"Force law calibration using bits {' and '.join(pairing.fitted)}, {words}",
                  f"{MARKS}{SYNTHETIC} {NOT_THEIRS}", with_law(rows, pairing.fitted))


def prediction_figure(results, name, counterpart, pairing, mode, words):
    r = results["hanson-hansen", pairing.name, mode]
    because = r.json["extrapolates_because"]
    outside = f"The prediction extrapolates ({'; '.join(because)}). " if because else ""
    return Figure(name, counterpart, f"Predicted values for bit {pairing.withheld} when calibrated using {words}",
                  f"{MARKS}The fit has not seen this bit. {outside}{SYNTHETIC} {NOT_THEIRS}", predicted(r.predicted, pairing.withheld))


def figures(results, records, exact, blind_rows):
    main, second, third = PAIRINGS
    together, apart = "both bottom hole pressures", "different coefficients for each bottom hole pressure"
    return [
        Figure("sample-record", "figure 6.2", "A sample record of the synthetic laboratory",
               "One bit at two bottom hole pressures: mean loads over the rate that was asked for. Noise: 3 % a reading, 3 % a test, and "
               f"2 % of the rate. {SYNTHETIC} {NOT_THEIRS}", sample_record(records, exact)),
        fit_figure(results, "fit-bc", "figure 6.3", main, "combined", together),
        prediction_figure(results, "prediction-a", "figure 6.4", main, "combined", together),
        fit_figure(results, "fit-bc-separate", "figure 6.5", main, "separate", apart),
        prediction_figure(results, "prediction-a-separate", "figure 6.6", main, "separate", "separate bottom hole pressures"),
        Figure("objectives", "", "Objectives of combined and separate fits, and the withheld bit",
               "Left: what table 6.4 shows. Right: what decides. The truth is one set of coefficients, and yet separate fits have the lower "
               f"objective. {SYNTHETIC}", objectives(results)),
        fit_figure(results, "fit-ac", "figure D.1", second, "combined", together),
        fit_figure(results, "fit-ab", "figure D.2", third, "combined", together),
        prediction_figure(results, "prediction-b", "figure D.3", second, "combined", "bits A and C"),
        prediction_figure(results, "prediction-c", "figure D.4", third, "combined", "bits A and B"),
        Figure("two-laws", "", "The withheld bit by two laws",
               "Hanson-Hansen made the records and follows them. The thin-cut law has no chamfers: its weight grows too steeply with the "
               f"rate. That says nothing of real rock. {SYNTHETIC}", two_laws(results)),
        Figure("blind", "", "Blind test: hidden laws against a Hanson-Hansen fit",
               "Errors against the hidden law's loads without noise; coverage of readings with noise. "
               f"{SYNTHETIC}", blind(blind_rows))]
