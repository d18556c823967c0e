"""Compares runs in which rock leaves a whole cutter at once (update.exit_from = "whole") with runs in which it leaves one part after another ("parts").

Every case is run three times: with both settings, and by parts with 0.7 times its edge length, for the mesh's own error. Where
forces move the bit, a run with 1.000001 times the edge length shows what rounding does.
"""

import numpy as np
from study_tools import ROOT
from result import distances, heights, read_ply

CELL, REACH = 0.25e-3, 0.107  # m
FINER, NUDGED = 0.7, 1.000001  # times the edge length
CASES = ["standard-workload", "bit-b-steady", "bit-a-steady", "bit-r-rolling", "bit-b-whirl", "drill-bit-b", "drill-bit-b-whirl"]
LARGE = 0.01  # of the removed volume: cutters with less are too noisy to compare one by one


class Compared:
    """The quantities of a run that are compared."""

    def __init__(self, m, case, factor, exit_from):
        edges = factor * {"bit-r-rolling": 2.5}.get(case, 1.0)  # mm
        has_revolutions = "\nrevolutions" in (ROOT / f"cases/{case}.toml").read_text(encoding="utf-8")
        run = m.run(f"cases/{case}.toml", {"rock.edge_length": f"{edges:.6f} mm", "update.exit_from": exit_from,
                                           **({"time.revolutions": 3} if has_revolutions else {"time.duration": "1.5 s"})})
        self.summary, self.history = run.summary, run.history
        self.surface = heights(*read_ply(run.folder / "rock_final.ply"), REACH, CELL)
        self.volumes = {}
        for part, volume in self.summary["removed_volume_by_part_m3"].items():
            self.volumes[part.partition("/")[0]] = self.volumes.get(part.partition("/")[0], 0.0) + volume

    def last_half(self, name):
        """Sums over the second half of the run, one for each part or cutter."""
        if name not in self.history:
            return None
        values = self.history[name].values
        return np.nansum(values[values.shape[0] // 2:], axis=0)

    def totals(self):
        """{quantity: number}, without the quantities that a case does not have."""
        s, h = self.summary, self.history
        found = {"removed volume, cm3": 1e6 * s["removed_volume_m3"]}
        for name, key in [("contact area, mm2", "contact_area_total"), ("section area, mm2", "section_area_total")]:
            if (sums := self.last_half(key)) is not None:
                found[name] = 1e6 * float(sums) / (h.sizes["time"] - h.sizes["time"] // 2)
        for name, key, scale in [("weight on bit, kN", "wob_mean_n", 1e-3), ("torque on bit, N m", "tob_mean_n_m", 1),
                                 ("rate of penetration, m/h", "rop_mean_m_per_s", 3600), ("imbalance", "imbalance", 1)]:
            if isinstance(s.get(key), float) and s[key] != 0.0 and s.get("wob_mean_n"):
                found[name] = scale * s[key]
        return found | {"moves a step": float(h["swept_vertices"].mean()), "triangles at the end": s["rock_triangles_end"],
                        "worst quality": s["rock_quality_min"], "1 % quality": s["rock_quality_1_percent"],
                        "bisections": s["counters"]["maintenance"]["bisections"], "ledger's defect": s["volume_ledger_defect"]}


def greatest_change(a, b):
    """The greatest relative change of the values that are large."""
    large = a > LARGE * a.sum()
    return float(np.max(abs(b[large] / a[large] - 1), initial=0.0))


def spreads(a, b):
    """{quantity: its greatest relative change between two runs}."""
    found = {"volume of a cutter, greatest change": greatest_change(*(np.array(list(r.volumes.values())) for r in (a, b)))}
    for name, key in [("contact area of a part, greatest change", "contact_area"), ("section area of a cutter, greatest change", "section_area")]:
        x, y = a.last_half(key), b.last_half(key)
        if x is not None and x.sum() > 0:
            found[name] = greatest_change(x, y)
    return found


def percent_of(x):
    return f"{100 * x:+.3g} %"


def rows_of(case, parts, other, finer, name, change):
    """Rows with the value of `other` in the column `name`, and its change in the column `change`."""
    headings = ["case", "quantity", "parts", name, change, "change with 0.7 times the edges"]
    before, after, fine = parts.totals(), other.totals(), finer.totals()
    rows = [[case, q, f"{x:.6g}", f"{after[q]:.6g}", *("" if abs(x) < 1e-12 else percent_of(r[q] / x - 1) for r in (after, fine))]
            for q, x in before.items()]
    mesh = spreads(parts, finer)
    rows += [[case, q, "", "", percent_of(x), percent_of(mesh[q])] for q, x in spreads(parts, other).items()]
    for q, pick in [("mean", np.mean), ("95th percentile", lambda d: np.percentile(d, 95)), ("greatest", np.max)]:
        apart = [1e3 * pick(distances(parts.surface, r.surface, REACH, CELL, 2e-3, 0.106)) for r in (other, finer)]
        rows.append([case, f"distance of surfaces, {q}, mm", "", "", f"{apart[0]:.3g}", f"{apart[1]:.3g}"])
    return [dict(zip(headings, row, strict=True)) for row in rows]


def owners_of(case, parts, whole):
    """Shares of the kinds of parts in the removed volume, %."""
    kinds = [str(k) for k in parts.history["part_kind"].values]
    for kind in dict.fromkeys(kinds):
        shares = []
        for run in (parts, whole):
            volumes = list(run.summary["removed_volume_by_part_m3"].values())
            shares.append(100 * sum(v for v, k in zip(volumes, kinds, strict=True) if k == kind) / sum(volumes))
        if max(shares) > 0:
            yield {"case": case, "kind of part": kind, "share by parts, %": f"{shares[0]:.1f}", "share by whole, %": f"{shares[1]:.1f}"}


def measure(m):
    """Parts for --only: names of cases, whose rows are replaced, and rounding."""
    differences, owners = [], []
    for case in filter(m.includes, CASES):
        parts, whole, finer = (Compared(m, case, f, x) for f, x in ((1.0, "parts"), (1.0, "whole"), (FINER, "parts")))
        differences += rows_of(case, parts, whole, finer, "whole", "change from parts to whole")
        owners += owners_of(case, parts, whole)
    if differences:
        m.replace("differences.csv", differences, "case", CASES)
        m.replace("owners.csv", owners, "case", CASES)
    if m.includes("rounding"):
        m.write("rounding.csv", (row for case in CASES if case.startswith("drill-") for row in rows_of(
            case, *(Compared(m, case, f, "parts") for f in (1.0, NUDGED, FINER)), "1.000001 times the edges", "change with 1.000001 times the edges")))
