"""Counterparts of tables 6.1 to 6.4, D.1 and D.2, and additional tables: identifiability, and the blind test."""

import math
import tomllib
from dataclasses import dataclass, field

import lab_runs
from lab_runs import PAIRINGS, PSI

SYNTHETIC = "Synthetic laboratory: the records were made by a law that we know, nothing was measured."
NOT_THEIRS = "We hold the title of the thesis's table, not its numbers."
MEANING = {
    "A1": "tangential stress of a face over the rock's strength", "A2": "its growth with tan(back rake)",
    "A3": "friction angle of a face", "A4": "stress along the edge over the strength",
    "A5": "contact stress of a chamfer over the strength", "A6": "friction of a chamfer",
    "pressure_share": "share of the strength's growth with pressure", "shear_angle": "angle of the shear plane",
    "blade_height": "height of the chip over that of the cut", "interface_share": "friction angle of the face over the rock's",
    "cohesion_share": "cohesion over that of the unconfined strength"}


@dataclass(frozen=True)
class Table:
    """Rows as written to the csv. The Markdown contains the same text."""

    name: str
    counterpart: str  # "table 6.1"; empty: not in the thesis
    title: str
    caption: str
    headings: list
    rows: list = field(hash=False)


def unit_of(c):
    return {"1": "", "rad": "deg"}.get(c["unit"], c["unit"])


def shown(value, unit):
    """A coefficient in the unit that the table shows."""
    if value is None:
        return ""
    number = math.degrees(value) if unit == "rad" else value
    return "0" if abs(number) < 1e-6 else f"{number:.3g}"


def interval(c):
    if c["at_bound"]:
        return "none"
    return f"{shown(c['low'], c['unit'])} to {shown(c['high'], c['unit'])}"


def flags(c):
    words = ["at an end of its range"] if c["at_bound"] else []
    if c["from_prior"] and not c["at_bound"]:
        words.append("mostly the prior's")
    return "; ".join(words)


def radians(text):
    value, _, unit = str(text).partition(" ")
    return math.radians(float(value)) if unit == "deg" else float(value)


def truth():
    """The laboratory's coefficients, SI."""
    document = tomllib.loads(lab_runs.LABORATORY.read_text(encoding="utf-8"))
    return {key: radians(value) for key, value in document["truth"].items() if key != "te"}


def in_psi(pressure):
    return f"{pressure / PSI:.0f} psi"


def percent(value):
    return f"{100 * value:.1f}"


def starts(results):
    rows = []
    for law in lab_runs.LAWS:
        for key, c in results[law, "bc-a", "combined"].json["coefficients"].items():
            rows.append([law, key, MEANING[key], unit_of(c), shown(c["start"], c["unit"]), shown(c["prior_sd"], c["unit"])])
    return Table("starts", "table 6.1", "Initial values of the force law's coefficients",
                 "Where each fit starts, and the standard deviation of the prior around it: from single-cutter tests (A1, A3, A5, A6), "
                 "from Miedema's chip (thin-cut) and assumed (the others). te is fixed at 0.1 mm, since only its product with A4 acts; "
                 "A7 and A8 are left out, since bits A, B and C have no part that feels them. " + SYNTHETIC + " " + NOT_THEIRS,
                 ["law", "coefficient", "meaning", "unit", "start", "prior deviation"], rows)


def coefficient_rows(result):
    """One row per coefficient and set. Includes the true value if the law is that of the laboratory."""
    known, rows = truth(), []
    for s in result.sets():
        where = in_psi(s["pressure_pa"]) if "pressure_pa" in s else "both"
        for key, c in s["coefficients"].items():
            is_inside = "" if c["at_bound"] else "yes" if c["low"] <= known[key] <= c["high"] else "no"
            rows.append([result.mode, where, key, unit_of(c), shown(c["start"], c["unit"]), shown(c["value"], c["unit"]),
                         interval(c), shown(known[key], c["unit"]), is_inside, flags(c)])
    return rows


COEFFICIENTS = ["fit", "pressure", "coefficient", "unit", "start", "value", "95 % interval", "truth", "truth inside", "flags"]


def count_inside(rows):
    told = [r[8] for r in rows if r[8]]
    return f"{told.count('yes')} of {len(told)} intervals hold the truth."


def coefficients(results, name, counterpart, pairing, modes, title):
    rows = [row for m in modes for row in coefficient_rows(results["hanson-hansen", pairing.name, m])]
    share = " At one pressure pressure_share cannot be seen: it is fixed at 1, so a true share below 1 makes other coefficients smaller." \
        if "separate" in modes else ""
    return Table(name, counterpart, title,
                 f"Fitted to bits {' and '.join(pairing.fitted)}; bit {pairing.withheld} is withheld. {count_inside(rows)}{share} "
                 f"{SYNTHETIC} {NOT_THEIRS}", COEFFICIENTS, rows)


def thin_cut_coefficients(results):
    rows = []
    for p in PAIRINGS:
        for mode in lab_runs.MODES:
            result = results["thin-cut", p.name, mode]
            for s in result.sets():
                where = in_psi(s["pressure_pa"]) if "pressure_pa" in s else "both"
                rows += [[p.words(), mode, where, key, unit_of(c), shown(c["start"], c["unit"]), shown(c["value"], c["unit"]), interval(c), flags(c)]
                         for key, c in s["coefficients"].items()]
    return Table("thin-cut", "", "The thin-cut law on the same records",
                 "Pressure and strength enter this law by a number each, blade_height and cohesion_share. It has no force on chamfers, and its coefficients run to the ends of "
                 "their ranges: it is not the law that made these records. " + SYNTHETIC,
                 ["pairing", "fit", "pressure", "coefficient", "unit", "start", "value", "95 % interval", "flags"], rows)


def objective_row(r):
    j = r.json
    return [r.law, r.pairing.words(), r.mode, f"{j['objective_wob']:.3g}", f"{j['objective_tob']:.3g}", j["degrees_of_freedom"],
            *(percent(j[f"{who}_bit_error_{load}_{what}"]) for who in ("fitted", "withheld") for load in ("wob", "tob")
              for what in (("rms",) if who == "fitted" else ("rms", "largest"))),
            "yes" if j["extrapolates"] else "no"]


def verdict(results):
    """The effect of separate fits on the objective and on the withheld bit, for each pairing, as numbers."""
    said = []
    for p in PAIRINGS:
        both = {m: results["hanson-hansen", p.name, m].json for m in lab_runs.MODES}
        total = {m: both[m]["objective_wob"] + both[m]["objective_tob"] for m in both}
        change = [100 * (both["separate"][f"withheld_bit_error_{k}_rms"] - both["combined"][f"withheld_bit_error_{k}_rms"]) for k in ("wob", "tob")]
        said.append(f"{p.words()}: objective {total['combined']:.1f} to {total['separate']:.1f}, withheld bit {change[0]:+.1f} and {change[1]:+.1f} points")
    return "From combined to separate fits (Hanson-Hansen): " + "; ".join(said) + "."


def objectives(results):
    rows = [objective_row(r) for r in results.values()]
    return Table("objectives", "table 6.4", "WOB and TOB objectives for separate and combined pressures, and the withheld bit",
                 "Sum of squared residuals of each load, in units of their noise, and beside it what decides: the error of the bit that "
                 "the fit has not seen, against its readings with their noise of 3 % each and 3 % a test (%, root mean square and "
                 "largest). Coefficients for each pressure lower the sum of the objectives also where, as here, one set for both is the truth: "
                 "judge on the withheld bit. "
                 + verdict(results) + " " + SYNTHETIC + " " + NOT_THEIRS,
                 ["law", "pairing", "fit", "WOB objective", "TOB objective", "degrees of freedom", "fitted bits, WOB rms %", "TOB rms %",
                  "withheld bit, WOB rms %", "WOB largest %", "TOB rms %", "TOB largest %", "extrapolates"], rows)


def identified(results):
    rows = []
    for p in PAIRINGS:
        for mode in lab_runs.MODES:
            for s in results["hanson-hansen", p.name, mode].sets():
                values = s["singular_values"]
                rows.append([p.words(), mode, in_psi(s["pressure_pa"]) if "pressure_pa" in s else "both",
                             ", ".join(f"{v:.3g}" for v in values),
                             f"{values[0] / values[-1]:.0f}" if values[-1] > 1e-9 * values[0] else "beyond 1e9",
                             s["weakest_direction_in_words"]])
    return Table("identified", "", "What the records see: singular values and the weakest direction",
                 "Singular values of the whitened readings over relative changes of the coefficients, priors left out. Below 1 the noise "
                 "hides even a doubling, and the value is the prior's. " + SYNTHETIC,
                 ["pairing", "fit", "pressure", "singular values", "condition", "weakest direction"], rows)


def blind(rows):
    lines = [[r["hidden law"], r["pairing"], r["draws"], percent(r["wob_rms"]), percent(r["tob_rms"]), percent(r["p95"]),
              f"{r['coverage']:.2f}", f"{r['extrapolates']:.2f}"] for r in rows]
    return Table("blind", "", "Blind test: hidden laws, predictions written before the truth is made",
                 "A hidden law drills; Hanson-Hansen with its prior is fitted to two bits and predicts the third. Error of the withheld "
                 "bit against the hidden law's loads without noise (%), share of noisy readings inside the 95 % intervals, share of draws "
                 "flagged as extrapolation. Where the law is wrong, intervals promise more than they hold. " + SYNTHETIC,
                 ["hidden law", "pairing", "draws", "WOB rms %", "TOB rms %", "p95 of both %", "coverage", "extrapolates"], lines)


def tables(results, blind_rows):
    main, second, third = PAIRINGS
    words = "Coefficients of the force law, calibrated for 3000 psi and 6000 psi"
    return [starts(results),
            coefficients(results, "coefficients-combined", "table 6.2", main, ["combined"], f"{words} together"),
            coefficients(results, "coefficients-separate", "table 6.3", main, ["separate"], f"{words} separately"),
            objectives(results),
            coefficients(results, "coefficients-ac", "table D.1", second, ["combined", "separate"], f"{words}: bits A and C"),
            coefficients(results, "coefficients-ab", "table D.2", third, ["combined", "separate"], f"{words}: bits A and B"),
            identified(results), thin_cut_coefficients(results), blind(blind_rows)]
