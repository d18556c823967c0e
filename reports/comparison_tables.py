"""The tables of the comparison of the models of chapter 2: expected and observed results, numbers, and what each model cannot predict. The
observed side of each expectation is computed from the results."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from study_tools import markdown_table

MODELS_1_TO_5 = ("warren-sinor", "behr", "glowka", "langeveld", "hanson-hansen")
SHARE_THE_LAW = ("warren-sinor", "behr", "langeveld", "hanson-hansen", "tdbd")
DRAG_BITS = ("bit-a", "bit-b", "bit-c")
MODELS_6_7_9_11 = ("briggs", "winters", "ma-zhou-deng", "sheppard-lesage")
ROLLER_TORQUE = (*MODELS_6_7_9_11, "huang-cawthorne-1", "huang-cawthorne-2")
ORBITS = {"whirl-1500": "1.5 mm", "whirl-3000": "3 mm"}
SHOWN_PLANES = 72  # of the runs with all models
STRENGTH = 100e6  # Pa, of the protocol's rock
SMALL_RADIUS, SMALL_AREA = 5e-3, 1e-6  # m, m2: cutters nearer to the axis or cutting less are left out
NOT_RUN = "no result in this protocol"


@dataclass(frozen=True)
class Verdict:
    expected: str
    observed: str
    holds: bool | None  # None: nothing to judge

    @property
    def word(self):
        return "not judged" if self.holds is None else "as expected" if self.holds else "**not as expected**"


def drag_runs(results):
    return [(g, r) for g in DRAG_BITS for _, r in results.get(g, [])]


def named(group, result):
    return f"{group[:3]} {group[4:].upper()} at {1e3 * result.advance:.3g} mm"


def percent(x):
    return "below 1e-6 %" if 0.0 < x < 1e-8 else f"{100.0 * x:.2g} %" if x < 0.1 else f"{100.0 * x:.0f} %"


def worst(found):
    """The entry of the largest number first in it, or None."""
    return max(found, key=lambda f: f[0], default=None)


def mean_of(results, quantity, expected, limit):
    """The largest deviation of models 1 to 5 from TDBD, over all runs."""
    found = [(abs(r.value(m, quantity) / r.value("tdbd", quantity) - 1.0), f"{r.titles[m]}, {named(g, r)}")
             for g, r in drag_runs(results) for m in MODELS_1_TO_5 if r.value(m, quantity)]
    if not found:
        return Verdict(expected, NOT_RUN, None)
    share, where = worst(found)
    middle = sorted(f[0] for f in found)[len(found) // 2]
    return Verdict(expected, f"median {percent(middle)}, worst {percent(share)} ({where})", share <= limit)


def torque_identity(results):
    expected = "torque eps R²d/2 within 0.2 %; for ours, which moves on a helix, T + W d/2 pi"
    found = []
    for g, r in drag_runs(results):
        for m in SHARE_THE_LAW:
            quantity = "work_of_a_turn_torque" if m == "tdbd" else "torque"  # TDBD moves on a helix
            if (torque := r.value(m, quantity)) is not None:
                exact = STRENGTH * r.gage_radius**2 * r.advance / 2.0
                found.append((abs(torque / exact - 1.0), f"{r.titles[m]}, {named(g, r)}"))
    if not found:
        return Verdict(expected, NOT_RUN, None)
    share, where = worst(found)
    return Verdict(expected, f"worst {percent(share)} ({where})", share <= 2e-3)


def area_differences(result):
    """[(relative difference, part)] of TDBD's areas from those of Warren and Sinor's plane."""
    ours, plane = result.parts("tdbd", "area"), result.parts("warren-sinor", "area")
    return [(abs(ours[p][1] / area - 1.0), p) for p, (radius, area) in plane.items()
            if p in ours and radius > SMALL_RADIUS and area > SMALL_AREA]


def areas(results):
    expected = "area of each cutter beyond 5 mm (and above 1 mm²) within 1 % of Warren and Sinor's after 3 revolutions"
    found = [(d, f"{p} of {named(g, r)}") for g, r in drag_runs(results) for d, p in area_differences(r)]
    if not found:
        return Verdict(expected, NOT_RUN, None)
    share, where = worst(found)
    within = sum(d <= 0.01 for d, _ in found)
    return Verdict(expected, f"{within} of {len(found)} areas; worst {percent(share)} ({where})", within == len(found))


def sums(results):
    expected = "removed volume of a revolution pi R²d within 0.5 %, every model"
    found = [(abs(r.value(m, "removed_per_revolution") / (math.pi * r.gage_radius**2 * r.advance) - 1.0), f"{r.titles[m]}, {named(g, r)}")
             for g, r in drag_runs(results) for m in r.titles if r.value(m, "removed_per_revolution")]
    if not found:
        return Verdict(expected, NOT_RUN, None)
    share, where = worst(found)
    return Verdict(expected, f"worst {percent(share)} ({where})", share <= 5e-3)


def noise(results, group, model, refined, printed):
    """The noise by crossing with this number of planes or spokes; `printed`: what was expected, as a share."""
    expected = f"torque noise by crossing with {refined}: {percent(printed)} (to a quarter)"
    for settings, r in results.get(group, []):
        if str(list(settings.values())[-1]) == refined.split()[0] and (seen := r.value(model, "torque_noise_by_crossing")):
            return Verdict(expected, percent(seen), abs(seen / printed - 1.0) <= 0.25)
    return Verdict(expected, NOT_RUN, None)


def spread_noise(results):
    """The comparison that was not foreseen as clearly: spokes whose crossings count for their time."""
    expected = "at equal CPU time spokes are noisier than the mesh"
    ours = [(r.cost("tdbd"), r.value("tdbd", "torque_noise")) for _, r in results.get("noise-mesh", [])]
    spread = [(r.cost(m), r.value(m, "torque_noise")) for g in ("noise-planes", "noise-spokes", "noise-outlines") for _, r in results.get(g, [])
              for m in r.titles if r.value(m, "torque_noise") is not None]
    if not ours or not spread:
        return Verdict(expected, NOT_RUN, None)
    (cost, least), (their_cost, theirs) = min(ours, key=lambda p: p[1]), min(spread, key=lambda p: p[0])
    return Verdict(expected, f"each crossing counting until the next spoke: {percent(theirs)} at {their_cost:.2g} s a second, ours at best {percent(least)} at {cost:.2g} s a second",
                   theirs > least)


def waves_of(results, group, model, planes, count):
    """The numbers of the strongest waves of a whirling bit's bottom; None without a result."""
    found = [r for s, r in results.get(group, []) if planes is None or str(s.get("compare.planes.planes")) == str(planes)]
    return found[0].strongest(model, count) if found else None


def planes_show(results, group, planes, expected_waves):
    """What so many planes show of the lobes, 73 or 37, by the literature's prototype."""
    expected = f"whirl, orbit of {ORBITS[group]}, {planes} planes: strongest waves {', '.join(map(str, expected_waves))}"
    in_group = (group, None) if planes == SHOWN_PLANES else (f"{group}-planes", planes)
    waves = waves_of(results, in_group[0], "behr", in_group[1], len(expected_waves))
    if waves is None:
        return Verdict(expected, NOT_RUN, None)
    return Verdict(expected, ", ".join(map(str, waves)), set(waves) == set(expected_waves))


def mesh_shows(results, group, lobes):
    """Whether our mesh shows the lobes themselves: as the strongest wave, or a multiple of it."""
    expected = f"whirl, orbit of {ORBITS[group]}, our mesh: the strongest wave is that of the {lobes} lobes or a multiple"
    waves = waves_of(results, group, "tdbd", None, 4)
    if waves is None:
        return Verdict(expected, NOT_RUN, None)
    return Verdict(expected, ", ".join(map(str, waves)), waves[0] % lobes == 0)


def roller_torque(results):
    expected = "roller bits: torque at equal weight spreads by 30 to 60 % among Briggs, Winters, Ma with Zhou and Deng, and Sheppard and Lesage"
    spreads = []
    for _, r in results.get("bit-r", []):
        torques = {m: r.value(m, "torque_at_weight") for m in MODELS_6_7_9_11 if r.value(m, "torque_at_weight")}
        if len(torques) > 1:
            low, high = min(torques, key=torques.get), max(torques, key=torques.get)
            mean = sum(torques.values()) / len(torques)
            spreads.append(((torques[high] - torques[low]) / mean, f"{r.titles[low]} {torques[low]:.0f} to {r.titles[high]} {torques[high]:.0f} N m"))
    if not spreads:
        return Verdict(expected, NOT_RUN, None)
    share, where = worst(spreads)
    return Verdict(expected, f"{percent(share)} ({where})", 0.3 <= share <= 0.6)


def fitted(results, model, quantity, ours, expected):
    """The result of a model with coefficients fitted to some runs of TDBD at every rate, over that of TDBD."""
    runs = [r for _, r in results.get("bit-r", []) if r.value(model, quantity) and ours(r)]
    found = [f"{100.0 * (r.value(model, quantity) / ours(r) - 1.0):+.2g} % at {1e3 * r.advance:.3g} mm" for r in runs]
    return Verdict(f"roller bits: {expected} (no number was stated)", ", ".join(found) or NOT_RUN, None)


def rate(result):
    """m/s of the case."""
    return result.advance * result.info["rotary_speed_rad_per_s"] / (2.0 * math.pi)


def ours_beside_roller_models(results):
    """No expectation was stated; the number is listed because it is large."""
    for _, r in results.get("bit-r", [])[1:2]:
        theirs = [r.value(m, "torque_at_weight") for m in ROLLER_TORQUE if r.value(m, "torque_at_weight")]
        if theirs and (ours := r.value("tdbd", "torque")):
            return Verdict("roller bits: TDBD beside the earlier models, torque at equal weight (nothing was expected; laws for teeth differ)",
                           f"{ours:.0f} N m against {min(theirs):.0f} to {max(theirs):.0f} N m", None)
    return Verdict("roller bits: TDBD beside the earlier models", NOT_RUN, None)


def in_whirl(results, group):
    """No expectation was stated; the numbers are listed because they are far apart."""
    expected = f"whirl, orbit of {ORBITS[group]}: weight and torque on planes and spokes beside TDBD's (nothing was stated)"
    for _, r in results.get(group, [])[:1]:
        seen = [f"{r.titles[m]} {1e-3 * r.value(m, 'weight'):.3g} kN, {r.value(m, 'torque'):.0f} N m"
                for m in ("tdbd", "behr", "langeveld", "hanson-hansen") if r.value(m, "weight") and r.value(m, "torque")]
        return Verdict(expected, "; ".join(seen) or NOT_RUN, None)
    return Verdict(expected, NOT_RUN, None)


def told_apart(results):
    """What no run of the protocol measures, and the one that comes nearest."""
    expected = "undercut wall, energy and lateral feedback tell the models apart"
    claims = "tested one by one (claims chapter2/undercut, chapter2/runge-kutta-loses-energy)"
    for _, r in results.get("bit-b-free", []):
        rates = [x for m in r.titles if (x := r.value(m, "rate_of_penetration")) is not None]
        if len(rates) > 1:
            apart = percent((max(rates) - min(rates)) / min(rates))
            return Verdict(expected, f"{claims}; on a string that holds the bit well, rates of {len(rates)} models are {apart} apart", None)
    return Verdict(expected, claims, None)


def gage(results):
    expected = "distance of samples at the gage: 9.42 mm (72 planes), 5.65 mm (120 spokes), 0.7 to 1 mm (mesh)"
    for _, r in results.get("bit-b", []):
        seen = [(r.titles[m], r.value(m, "resolution_at_gage")) for m in ("behr", "langeveld", "tdbd") if r.value(m, "resolution_at_gage")]
        if len(seen) == 3:
            good = all(abs(1e3 * x - e) <= room for (_, x), (e, room) in zip(seen, ((9.42, 0.01), (5.65, 0.01), (0.85, 0.151))))
            return Verdict(expected, ", ".join(f"{1e3 * x:.3g} mm ({name})" for name, x in seen), good)
    return Verdict(expected, NOT_RUN, None)


def verdicts(results):
    """All of them, in the protocol's order."""
    return [
        mean_of(results, "weight", "steady weight within 1 to 3 % among models 1 to 5 and TDBD", 0.03),
        mean_of(results, "torque", "steady torque likewise", 0.03),
        areas(results), torque_identity(results), sums(results),
        noise(results, "noise-planes", "behr", "72 planes", 0.26), noise(results, "noise-spokes", "langeveld", "120 spokes", 0.23),
        noise(results, "noise-planes", "behr", "360 planes", 0.067), spread_noise(results), gage(results),
        planes_show(results, "whirl-1500", 72, (1, 3, 4, 2)), planes_show(results, "whirl-1500", 720, (73, 146, 74, 219)),
        mesh_shows(results, "whirl-1500", 73),
        planes_show(results, "whirl-3000", 72, (33, 2, 31)), planes_show(results, "whirl-3000", 720, (111, 74, 36)),
        mesh_shows(results, "whirl-3000", 37), in_whirl(results, "whirl-1500"), in_whirl(results, "whirl-3000"), roller_torque(results),
        fitted(results, "sheppard-lesage", "weight", lambda r: r.value("tdbd", "weight"), "Sheppard and Lesage, fitted at 2.08 mm: weight over TDBD's"),
        fitted(results, "winters", "rate_at_weight", rate, "Winters et al., fitted at the first three rates: rate over TDBD's"),
        ours_beside_roller_models(results),
        told_apart(results)]


SHOWN = {"bit-b": "bit B", "bit-b-free": "bit B on a string", "whirl-1500": "bit B in whirl, orbit of 1.5 mm", "bit-r": "the roller cone bit", "bit-r-4": "the same, journals offset by 4 mm",
         "bit-r-8": "the same, journals offset by 8 mm"}


@dataclass(frozen=True)
class Table:
    title: str
    caption: str
    write: Callable  # results -> Markdown


def words(quantity):
    return quantity.replace("_", " ")


def middle(runs):
    """The result in the middle of a sweep."""
    return runs[len(runs) // 2][1]


def expected_and_observed(results):
    rows = [[v.expected, v.observed, v.word] for v in verdicts(results)]
    return markdown_table(["Expected, stated before the runs", "Observed", "Verdict"], rows)


def number(value):
    return "–" if value is None else f"{value:.4g}"


def numbers_of(result):
    """A row for each quantity that any model has, a column for each model; the cost last."""
    rows = [[f"{words(q)} ({unit})" if unit != "1" else words(q), *(number(result.value(m, q)) for m in result.titles)]
            for q, unit in result.quantities.items() if any(result.value(m, q) is not None for m in result.titles)]
    rows.append(["CPU time over simulated time, measured once", *(number(result.cost(m)) for m in result.titles)])
    notes = "".join(f"- {m['title']}: {note}\n" for m in result.info["models"] for note in m.get("notes", []))
    return markdown_table(["", *result.titles.values()], rows) + (f"\n{notes}" if notes else "")


def given(result):
    """What the case gives: an advance, or nothing of a bit on a string."""
    return f", {1e3 * result.advance:.3g} mm a revolution" if result.advance > 0.0 else ""


def numbers(results):
    return "\n".join(f"**{name[0].upper()}{name[1:]}**{given(middle(results[g]))}:\n\n{numbers_of(middle(results[g]))}"
                     for g, name in SHOWN.items() if g in results)


def reasons_of(result):
    """{(model's title, reason): quantities}."""
    found = {}
    for (model, quantity), reason in result.reasons.items():
        found.setdefault((result.titles[model], reason), []).append(words(quantity))
    return found


def cannot_say(results):
    found = {}
    for group in ("bit-b", "bit-r"):
        if group in results:
            for key, quantities in reasons_of(middle(results[group])).items():
                found.setdefault(key, quantities)
    rows, before = [], None
    for (title, reason), quantities in found.items():
        rows.append([title if title != before else "", ", ".join(quantities), reason])
        before = title
    return markdown_table(["Model", "Cannot say", "Because"], rows)


TABLES = {
    "expected": Table("Expected and observed",
                      "What the protocol expected was written down before any run; what came out is computed from the results. Deviations are from TDBD, unless said otherwise.",
                      expected_and_observed),
    "numbers": Table("What the models say", "A dash: the model cannot say it; the next table has the reasons.", numbers),
    "cannot-say": Table("What each model cannot say", "Quantities of tdbd-compare without a number, with the reason that the program gives.", cannot_say),
}
