"""The numbers of a result as tables of a page, in the units of the trade. Keys that a result does not have are left out."""

import math

RPM, M_PER_H, KN, MPA = 30.0 / math.pi, 3600.0, 1e-3, 1e-6


def number(value, digits=4):
    """A value with so many digits, without rounding errors and without an exponent where there need be none."""
    if isinstance(value, bool) or value is None or isinstance(value, str):
        return {True: "yes", False: "no", None: "-"}.get(value, value)
    if not math.isfinite(value):
        return "-"
    text = f"{value + 0.0:.{digits}g}"
    return f"{float(text):.0f}" if "e+" in text and abs(value) < 1e9 else text


def with_spread(summary, name, factor, unit):
    """Mean and standard deviation of a load; a spread below rounding is omitted."""
    mean, spread = (summary.get(f"{name}".replace("*", which)) for which in ("mean", "std"))
    text = f"{number(factor * mean)} {unit}"
    if spread is not None and spread > 1e-6 * abs(mean):
        text += f", standard deviation {number(factor * spread, 3)} {unit}"
    return text


def loads(summary):
    """Weight, torque, rate, speed, energy and imbalance of a run with forces."""
    rows = []
    for what, key, factor, unit in (("weight on bit", "wob_*_n", KN, "kN"), ("torque on bit", "tob_*_n_m", KN, "kN m"),
                                    ("rate of penetration", "rop_*_m_per_s", M_PER_H, "m/h"),
                                    ("rotary speed", "rotary_speed_*_rad_per_s", RPM, "rpm")):
        if summary.get(key.replace("*", "mean")) is not None:
            rows.append((what, with_spread(summary, key, factor, unit)))
    if summary.get("mechanical_specific_energy_pa") is not None:
        rows.append(("mechanical specific energy", f"{number(MPA * summary['mechanical_specific_energy_pa'])} MPa"))
    if summary.get("imbalance") is not None:
        rows.append(("imbalance: mean lateral force over the weight", f"{number(100 * summary['imbalance'], 3)} %, towards "
                     f"{math.degrees(summary.get('imbalance_azimuth_rad') or 0.0):.0f} deg of the bit"))
    if summary.get("drilling_power_mean_w") is not None:
        rows.append(("drilling power", f"{number(1e-3 * summary['drilling_power_mean_w'])} kW"))
    if rows and summary.get("means_from_s") is not None:
        rows.append(("means over", f"{number(summary['means_from_s'])} to {number(summary['means_to_s'])} s"))
    return rows


def of_run(summary):
    rows = [("status", summary["status"]), ("drilled", f"{number(summary['revolutions'])} revolutions in {number(summary['duration_s'])} s, "
                                            f"{summary['steps']} steps")]
    rows += loads(summary)
    rows.append(("diagnosis", (summary.get("diagnosis") or {}).get("text") or "none: the motion of this run is given"))
    rows.append(("rock removed", f"{number(1e6 * summary['removed_volume_m3'])} cm³; defect of the volume balance "
                 f"{summary['volume_ledger_defect']:.1e}"))
    rows.append(("diameter of the gage", f"{number(2e3 * summary['gage_radius_m'], 6)} mm"))
    return rows


def of_rotation(summary):
    integrator = summary["integrator"]
    rows = [("status", summary["status"]), ("integrated", f"{number(summary['duration_s'])} s in {summary['steps']} steps of {number(summary['step_s'])} s"),
            ("integrator", f"drift {integrator['drift']}, order {integrator['order']}"), ("torque evaluations", str(summary["torque_evaluations"])),
            ("largest change of the energy, over its scale", f"{summary['energy_drift_max']:.2e}"),
            ("largest change of the momentum in space", f"{summary['momentum_drift_max']:.2e} N m s"),
            ("largest change of its vertical component", f"{summary['vertical_momentum_drift_max']:.2e} N m s"),
            ("angular velocity at the end, body frame", ", ".join(number(w) for w in summary["angular_velocity"]) + " rad/s")]
    if summary.get("cone_spins"):
        rows.append(("spins of the cones at the end", ", ".join(number(w) for w in summary["cone_spins"]) + " rad/s"))
    return rows


def of_study(study):
    rows = [("status", study["status"]), ("refined", f"{study['over']}, {len(study['levels'])} levels, factor {number(study['factor'])}"),
            ("nominal order", number(study.get("nominal_order")))]
    return rows + [(f"order of {name.replace('_', ' ')}", v.get("in_words") or number(v["order"])) for name, v in study["variables"].items()]


def of_calibration(found):
    rows = [] if "chi2" not in found else [("chi2", f"{number(found['chi2'])} at {found['degrees_of_freedom']} degrees of freedom")]
    for name, c in found.get("coefficients", {}).items():
        ends = "at an end of its range: no interval" if c["low"] is None else f"{number(c['low'])} to {number(c['high'])}"
        rows.append((name, f"{number(c['value'])}{'' if c['unit'] == '1' else ' ' + c['unit']}, {ends}"))
    for key, words in (("fitted_bit_error", "fitted records"), ("withheld_bit_error", "withheld records")):
        for name, value in found.items():
            if name.startswith(f"{key}_") and name.endswith("_rms") and value is not None:
                load = name.removeprefix(f"{key}_").removesuffix("_rms")
                rows.append((f"error of {load}, {words}", f"{number(100 * value, 3)} % rms"))
    return rows + [("extrapolates", why) for why in found.get("extrapolates_because", [])]


def of_string(summary):
    rows = [("status", summary.get("status", "-"))]
    for key, words in (("axial_frequencies_hz", "axial vibrations"), ("torsional_frequencies_hz", "torsional vibrations")):
        if summary.get(key):
            rows.append((words, ", ".join(number(f) for f in summary[key][:5]) + " Hz"))
    return rows


def of_curve(summary):
    """The message of each rock, and the points of the curve."""
    rows = [(row["rock"], row["message"]) for row in summary["rates"]]
    drifting = sum(row.get("steady") == "no" for row in summary["curve"])
    if drifting:
        rows.append(("not steady", f"{drifting} of {len(summary['curve'])} runs: their means drift; run longer"))
    for row in summary["curve"]:
        what = f"{row['rock']}, {number(KN * float(row['weight_set_n']))} kN"
        values = [f"{number(float(row[key]))} {unit}" for key, unit in (("rop_mean_m_per_h", "m/h"), ("tob_mean_n_m", "N m"))]
        rows.append((what, row.get("message") or ", ".join(values) + (", not steady" if row.get("steady") == "no" else "")))
    return rows


def of_sweep(summary):
    """The points, what was varied, and the range of each result."""
    done, all_points = len(summary["points"]), len(summary["points"]) + summary["failed"]
    rows = [("points", f"{done} of {all_points} are done" if summary["failed"] else f"{done}")]
    if summary.get("unsteady"):
        rows.append(("not steady", f"the means of {summary['unsteady']} points drift; run longer"))
    for kind in ("factor", "figure"):
        rows += [(f"{kind} {name}", text) for name, text in summary[f"{kind}s"]]
    return rows


FACTS = {"sweep": of_sweep, "curve": of_curve, "run": of_run, "rotation": of_rotation, "convergence": of_study, "calibration": of_calibration, "string": of_string}
MOST_POINTS = 200
FORCE_HEADS = ("part", "normal force kN", "tangential force kN", "power kW", "specific energy MPa")


def forces(summary):
    """(heads, rows): mean forces of each part of the bit; empty without forces."""
    rows = [(part["name"], number(KN * part["normal_mean_n"]), number(KN * part["tangential_mean_n"]), number(KN * part["power_mean_w"]),
             number(MPA * part["specific_energy_pa"]) if part.get("specific_energy_pa") else "-") for part in summary.get("forces", [])]
    return FORCE_HEADS, rows


def table(kind, summary):
    """(title, heads, rows): the points of a sweep; of other results the mean forces of each part."""
    if kind != "sweep":
        return "Forces by part", *forces(summary)
    shown = summary["points"][:MOST_POINTS]
    more = f", the first {MOST_POINTS} of {len(summary['points'])}" if len(summary["points"]) > MOST_POINTS else ""
    return f"Points that are done{more}", summary["heads"], [[number(v) for v in row] for row in shown]


def provenance(summary):
    keys = ("source", "command", "version", "commit", "compiler", "flags", "case_hash", "seed")
    return [(key.replace("_", " "), str(summary[key])) for key in keys if summary.get(key) is not None]
