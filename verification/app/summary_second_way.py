"""summary_second_way.py TDBD CASE.toml FOLDER: every figure of summary.json that the record gives.

Runs the first moments of a dynamic case on coarse rock with a row of the history for every step, and
computes the means, deviations, rates, energies, diagnosis and volumes of summary.json again: from
history.csv, from history.nc, from sums over parts, and from the balance of energy.
"""

import csv
import json
import math
import re
import subprocess
import sys

import netCDF4
import numpy as np

ROUNDING = 1e-9   # of sums over a few hundred rows, printed with 17 digits
DURATION, MEANS_FROM = 0.06, 0.024   # s

tdbd, case, folder = sys.argv[1:]
subprocess.run([tdbd, "run", case, "-o", folder, "--force", "--quiet",
                "--set", "rock.edge_length='6 mm'", "--set", f"time.duration={DURATION}",
                "--set", f"output.means_from={MEANS_FROM}", "--set", "output.history_every=1",
                "--set", "output.energy_order=off"], check=True)
with open(folder + "/summary.json", encoding="utf-8") as file:
    summary = json.load(file)


def history_of_csv():
    with open(folder + "/history.csv", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [re.sub(r" \[.*", "", name) for name in rows[0]]
    return {name: np.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(names)}


h = history_of_csv()
time = h["time"]
dt = time[-1] / len(time)
counts = time > summary["means_from_s"] + 0.5 * dt
compared = set()


def same(key, value, scale=None, found=None, within=ROUNDING):
    """The figure of the summary is `value`; `scale` where that may be near 0."""
    found = summary[key] if found is None else found
    size = max(abs(value), abs(found)) if scale is None else scale
    assert abs(found - value) <= within * size + 1e-300, (key, found, value, found - value, size)
    compared.add(key)


def spread(key, column, unit, within=ROUNDING):
    x = h[column][counts]
    size = np.abs(x).max()
    same(f"{key}_mean_{unit}", x.mean(), size, within=within)
    same(f"{key}_std_{unit}", x.std(), x.std() + 1e-4 * size)


def means():
    same("steps", len(time))
    same("means_to_s", time[-1])
    spread("wob", "weight_on_bit", "n")
    spread("tob", "torque_on_bit", "n_m")
    spread("rop", "rate_of_penetration", "m_per_s")
    spread("rotary_speed", "rotary_speed", "rad_per_s")
    same("drilling_power_mean_w", h["drilling_power"][counts].mean(),
         np.abs(h["drilling_power"]).max())


def uncertainties():
    """Student's t of the means of eight batches; 2.364624 is its quantile at 97.5 % for seven."""
    columns = {"wob_mean_n": "weight_on_bit", "tob_mean_n_m": "torque_on_bit",
               "rop_mean_m_per_s": "rate_of_penetration",
               "rotary_speed_mean_rad_per_s": "rotary_speed"}
    for key, column in columns.items():
        x = h[column][counts]
        length = len(x) // 8
        batches = x[-8 * length:].reshape(8, length).mean(axis=1)
        same("uncertainty/" + key, 2.364624 * batches.std(ddof=1) / math.sqrt(8), np.abs(x).max(),
             summary["uncertainty"][key])


def steadiness():
    """Means of two halves of eight batches each, and the ratio of the means of force and weight."""
    turns = abs(h["rotary_speed"][counts].sum()) * dt / (2 * math.pi)
    same("steady_test/revolutions", turns, found=summary["steady_test"]["revolutions"])
    assert (summary["steady"] is None) == (turns < 0.99), summary["steady_test"]
    drifts = []
    for key, column in (("wob_mean_n", "weight_on_bit"), ("tob_mean_n_m", "torque_on_bit"),
                        ("rop_mean_m_per_s", "rate_of_penetration"), ("rotary_speed_mean_rad_per_s", "rotary_speed")):
        if summary["steady"] is None:
            break
        x = h[column][counts]
        means = x[-(len(x) // 16 * 16):].reshape(2, 8, -1).mean(axis=2)
        change = means[1].mean() - means[0].mean()
        t = change / max(math.sqrt(means.var(axis=1, ddof=1).sum() / 8), 1e-9 * np.abs(means.mean(axis=1)).max())
        same("steady_test/" + key, t, found=summary["steady_test"]["means"][key]["t"], within=1e-6)
        drifts.append(abs(t) > 2.863994 and abs(change) > 0.01 * np.abs(means.mean(axis=1)).max())
    assert summary["steady"] is None or summary["steady"] == (not any(drifts)), summary["steady_test"]
    if summary["wob_mean_n"] > 0:
        across = np.array([lateral_B(i) for i in np.flatnonzero(counts)])
        along = across @ across.mean(axis=0) / np.hypot(*across.mean(axis=0))
        error = along - summary["imbalance"] * h["weight_on_bit"][counts]
        length = len(error) // 8
        batches = error[-8 * length:].reshape(8, length).mean(axis=1)
        same("uncertainty/imbalance", 2.364624 * batches.std(ddof=1) / math.sqrt(8) / summary["wob_mean_n"],
             np.abs(error).max() / summary["wob_mean_n"], summary["uncertainty"]["imbalance"], within=1e-7)


def displacements():
    """Means of rates are displacements over time, of the bit over the rock."""
    first = np.flatnonzero(counts)[0]
    z = h["position_z"] - h["rock_position_z"]
    span = time[-1] - time[first - 1]
    same("rop_mean_m_per_s", (z[-1] - z[first - 1]) / span, np.ptp(z) / span + 1e-12)
    same("rotary_speed_mean_rad_per_s",
         (h["rotation_angle"][-1] - h["rotation_angle"][first - 1]) / span)
    same("revolutions", h["rotation_angle"][-1] / (2 * math.pi))


def figures():
    wob, tob = summary["wob_mean_n"], summary["tob_mean_n_m"]
    radius = summary["gage_radius_m"]
    if wob > 0:
        same("aggressiveness", 3 * tob / (2 * radius * wob))
        mean = np.mean([lateral_B(i) for i in np.flatnonzero(counts)], axis=0)
        same("imbalance", np.hypot(*mean) / wob)
    if summary["rop_mean_m_per_s"] > 0:
        area = math.pi * radius**2
        work = summary["rotary_speed_mean_rad_per_s"] * tob / summary["rop_mean_m_per_s"]
        same("mechanical_specific_energy_pa", (wob + work) / area)


def lateral_B(i):
    """Force across the bit's axis in its own frame, N."""
    r = np.array([h[f"rotation_vector_{c}"][i] for c in "xyz"])
    force = np.array([h["force_x"][i], h["force_y"][i], -h["weight_on_bit"][i]])
    angle = np.linalg.norm(r)
    k = r / angle
    turned = (force * math.cos(angle) - np.cross(k, force) * math.sin(angle)
              + k * k.dot(force) * (1 - math.cos(angle)))
    return turned[:2]


def energies():
    e = summary["energy"]
    put_in = e["start_j"] + e["top_j"] + e["gravity_j"] + e["chain_gravity_j"] + e["cutting_to_rock_motion_j"]
    lost = sum(e[key] for key in ("cutting_j", "damped_string_j", "damped_bearings_j",
                                  "damped_rock_j", "wall_loss_j", "wall_friction_j", "chain_friction_j", "chain_damping_j",
                                  "chain_loss_j", "top_damping_j"))
    stored = e["kinetic_j"] + e["elastic_j"] + e["chain_j"]
    same("residual_j", stored + lost - put_in, put_in, e["residual_j"], within=1e-13)
    # Power times step is of first order: of bit M, whose teeth land on the rock here, 1.0, 0.5, 0.3, 0.2 % at 1, 0.5, 0.25, 0.125 ms.
    lands = "drill-bit-m" in case
    same("cutting_by_part_j", sum(e["cutting_by_part_j"].values()),
         e["cutting_j"] + e["start_j"], e["cutting_j"] - e["cutting_to_rock_motion_j"], within=1.2e-2 if lands else 1e-2)
    last = {key: h[key][-1] for key in h}
    same("energy_stored", stored, found=last["energy_stored"])
    same("work_of_top", e["top_j"], put_in, last["work_of_top"])
    same("work_on_rock", e["cutting_j"], put_in, last["work_on_rock"])
    same("energy_residual", e["residual_j"], put_in, last["energy_residual"])


def parts():
    """Sums over parts: power, volume."""
    same("drilling_power_mean_w", sum(part["power_mean_w"] for part in summary["forces"]),
         np.abs(h["drilling_power"]).max())
    removed = summary["removed_volume_m3"]
    same("removed_volume_m3", sum(summary["removed_volume_by_part_m3"].values()))
    same("removed_volume_m3", sum(summary["removed_volume_by_revolution_m3"]))
    same("removed_volume_m3", h["removed_volume_total"][-1])
    for name, turns in summary["removed_volume_by_part_by_revolution_m3"].items():
        same(name, sum(turns), removed, summary["removed_volume_by_part_m3"][name])


def diagnosis():
    d = summary["diagnosis"]
    x, y = h["position_x"][counts], h["position_y"][counts]
    orbit = np.hypot(x - x.mean(), y - y.mean())
    same("orbit_radius_m", math.sqrt((orbit**2).mean()), found=d["orbit_radius_m"])
    turns = np.unwrap(np.arctan2(y - y.mean(), x - x.mean()))
    span = dt * (counts.sum() - 1)
    same("orbit_frequency_hz", (turns[-1] - turns[0]) / (2 * math.pi * span), 1 / span,
         d["orbit_frequency_hz"], within=1e-2)
    wob = h["weight_on_bit"][counts]
    same("lost_contact_share", (wob <= 0).mean(), 1, d["lost_contact_share"])
    if wob.mean() > 0:
        same("wob_swing", np.ptp(wob) / (2 * wob.mean()), found=d["wob_swing"])


def netcdf():
    with netCDF4.Dataset(folder + "/history.nc") as nc:
        names = set(nc.variables) & set(h)
        assert len(names) >= 0.9 * len(h), set(h) - names
        for name in names:
            assert np.array_equal(np.ma.filled(nc[name][:], np.nan), h[name]), name


means()
uncertainties()
steadiness()
displacements()
figures()
energies()
parts()
diagnosis()
netcdf()
print(f"{len(compared)} figures agree")
