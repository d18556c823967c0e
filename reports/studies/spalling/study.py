"""Effects of rock that breaks out: single grooves, neighbouring grooves, a rotating bit, the comparisons of validation/."""

import sys
from pathlib import Path

import numpy as np
from study_tools import ROOT, read_rows

HERE = Path(__file__).resolve().parent
DIAMETER, RAKE, DEPTH, SIDES = 13e-3, np.radians(15.0), 3e-3, 64


class Rock:
    """Flat rock in columns, in which a polygonal face cuts parallel grooves. It shares no code with TDBD."""

    def __init__(self, half_width=35e-3, columns=28001):
        self.y = np.linspace(-half_width, half_width, columns)
        self.bottom = np.zeros(columns)

    def face(self, middle):
        """Depth of the face's edge."""
        turns = 2.0 * np.pi * np.arange(-SIDES // 4, SIDES // 4 + 1) / SIDES
        y, z = 0.5 * DIAMETER * np.sin(turns), 0.5 * DIAMETER * (1.0 - np.cos(turns)) * np.cos(RAKE)
        return DEPTH - np.interp(self.y - middle, y, z, left=np.inf, right=np.inf)

    def groove(self, middle, angle, share, ahead):
        """Areas that the face cuts, and that break out ahead of and beside it, m2. Angle in degrees; 0: nothing breaks out."""
        before, face, width = self.bottom.copy(), self.face(middle), self.y[1] - self.y[0]
        engaged, height = face > before, DEPTH - face
        tops = [height[engaged & side].max(initial=0.0) for side in (self.y <= middle, self.y > middle)]
        chipped = np.maximum(0.0, face - (1.0 - ahead) * max(tops) - before) if ahead > 0.0 else np.zeros_like(face)
        cut = np.maximum(0.0, face - before) - chipped
        self.bottom = np.maximum(before, face)
        groove = self.bottom.copy()
        if angle > 0.0 and share > 0.0:
            tangent = np.tan(np.radians(angle))
            for k in np.flatnonzero(engaged):
                right = self.y[k] > middle
                if height[k] < (1.0 - share) * tops[int(right)]:
                    continue
                way = (self.y - self.y[k]) * (1.0 if right else -1.0)
                crack = np.where((way > 0.0) & (way < (tops[int(right)] - height[k]) * tangent), face[k] - way / tangent, -np.inf)
                self.bottom = np.maximum(self.bottom, crack)
        return [float(a.sum() * width) for a in (cut, chipped, self.bottom - groove)]


# The figure.


def colours():
    from figures import style
    return {0.0: style.GREY, 60.0: style.BLUE, 70.0: style.RED}


def draw_groove(axes):
    for angle, colour in colours().items():
        rock = Rock()
        rock.groove(0.0, angle, 1.0, 0.0)
        near = np.abs(rock.y) < 10e-3
        axes.plot(1e3 * rock.y[near], -1e3 * rock.bottom[near], color=colour, label=f"{angle:.0f} degrees" if angle else "none")


def draw_neighbours(axes):
    for angle, colour in colours().items():
        rows = read_rows(HERE / "neighbours.csv").where("angle, degrees", angle)
        axes.plot(rows["spacing, mm"], rows["exact, mm2"], color=colour)
        axes.plot(rows["spacing, mm"], rows["section of the second groove, mm2"], "o", color=colour)


def draw_errors(axes):
    table = read_rows(HERE / "grooves.csv").where("step, ms", 2.0)
    for (angle, share, ahead), marker in zip(GROOVES, "so^vd"):
        rows = table.where("angle, degrees", angle, "depth share", share, "ahead share", ahead)
        label = f"{angle:.0f} degrees, {share:g}, ahead {ahead:g}" if angle else "none"
        axes.plot(rows["edge, mm"], [abs(e) for e in rows["error"]], marker=marker, label=label)


# Measurement.

GROOVES = ((0, 0.0, 0.0), (60, 1.0, 0.0), (70, 1.0, 0.0), (70, 0.5, 0.0), (70, 1.0, 0.5))  # angle, depth share, ahead share
LEVELS = ((2.0, 2.0), (1.4, 2.0), (1.0, 2.0), (0.7, 2.0), (0.5, 2.0), (1.0, 8.0), (1.0, 4.0), (1.0, 1.0), (1.0, 0.5))  # edge, step
BITS = ((0, 0.0), (60, 0.0), (65, 0.0), (70, 0.0), (75, 0.0), (70, 0.3))  # angle, ahead share
VARIANTS = {"none": [], "beside, 60 degrees": ["--set", "spalling.angle=60 deg"], "beside, 75 degrees": ["--set", "spalling.angle=75 deg"],
            "beside, 60 degrees, half ahead": ["--set", "spalling.angle=60 deg", "--set", "spalling.ahead_share=0.5"]}


def spalling(angle, share=1.0, ahead=0.0):
    return ["--set", f"spalling={{angle='{angle} deg', depth_share={share}, ahead_share={ahead}}}"] if angle else []


def measured_groove(m, settings, words, start):
    """Removed area (slope of the volume over the distance) and section across the path, m2, and drag, N, in the middle of a groove."""
    run = m.run(HERE / "groove.toml", settings, words=words)
    assert run.summary["volume_ledger_defect"] <= 1e-12
    h = {name: run.history[name].values for name in ("time", "position_y", "removed_volume_total", "section_area_total", "force_y")}
    inside = (h["time"] > start) & (h["position_y"] > -8e-3) & (h["position_y"] < 10e-3)
    area = np.polyfit(h["position_y"][inside], h["removed_volume_total"][inside], 1)[0]
    return area, h["section_area_total"][inside].mean() * np.cos(RAKE), -h["force_y"][inside].mean()


def grooves_of(m):
    for angle, share, ahead in GROOVES:
        cut, chipped, beside = Rock().groove(0.0, angle, share, ahead)
        exact = cut + chipped + beside
        for edge, step in LEVELS:
            settings = {"rock.edge_length": f"{edge} mm", "time.step": f"{step} ms", "time.duration": 0.92}
            area, section, _ = measured_groove(m, settings, spalling(angle, share, ahead), 0.2)
            yield {"angle, degrees": angle, "depth share": share, "ahead share": ahead, "edge, mm": edge, "step, ms": step,
                   "area that leaves, mm2": f"{1e6 * area:.4f}", "exact, mm2": f"{1e6 * exact:.4f}", "error": f"{area / exact - 1.0:.1e}",
                   "section, mm2": f"{1e6 * section:.4f}", "its exact value, mm2": f"{1e6 * cut:.4f}", "its error": f"{section / cut - 1.0:.1e}"}


def legs(spacing):
    """The legs of groove.toml with another spacing."""
    ways = [(0.1, (0, -0.2, -0.05)), (0.1, (0, 0.02, 0.08)), (0.72, (0, 0.05, 0)), (0.1, (0, 0, -0.08)),
            (0.2, (spacing / 0.2, -0.19, 0)), (0.1, (0, 0.02, 0.08)), (0.72, (0, 0.05, 0))]
    return "[" + ", ".join(f"{{duration={t}, velocity=[{', '.join(f'{float(v)}' for v in way)}]}}" for t, way in ways) + "]"


def neighbours_of(m):
    for spacing in (5.0, 7.0, 9.0, 11.0, 13.0, 17.0):
        for angle in (0, 60, 70):
            rock = Rock()
            rock.groove(0.0, angle, 1.0, 0.0)
            cut, _, beside = rock.groove(1e-3 * spacing, angle, 1.0, 0.0)
            area, section, drag = measured_groove(m, {}, ["--set", "motion.legs=" + legs(1e-3 * spacing), *spalling(angle)], 1.32)
            yield {"spacing, mm": spacing, "angle, degrees": angle, "section of the second groove, mm2": f"{1e6 * section:.3f}",
                   "exact, mm2": f"{1e6 * cut:.3f}", "its drag, N": f"{drag:.1f}", "area that leaves, mm2": f"{1e6 * area:.3f}",
                   "its exact value, mm2": f"{1e6 * (cut + beside):.3f}", "specific energy, MPa": f"{1e-6 * drag / area:.2f}"}


def turning_bit(m):
    """Bit B at 5 mm a revolution, the third turn."""
    for angle, ahead in BITS:
        for edge in (2.0, 1.4, 1.0):
            settings = {"rock.edge_length": f"{edge} mm", "rock.pressure": 0, "time.revolutions": 3, "output.means_from": "1 s",
                        "motion.rotary_speed": "120 rpm", "motion.rate_of_penetration": "36 m/h"}
            s = m.run("cases/bit-b-3000psi.toml", settings, words=spalling(angle, 1.0, ahead)).summary
            broken, turn = sum(s.get("broken_out_volume_by_cutter_m3", {}).values()), s["removed_volume_by_revolution_m3"][2]
            yield {"angle, degrees": angle, "ahead share": ahead, "edge, mm": edge, "weight, N": f"{s['wob_mean_n']:.0f}",
                   "torque, N m": f"{s['tob_mean_n_m']:.1f}", "removed in the third turn, cm3": f"{1e6 * turn:.3f}",
                   "share broken out": f"{broken / s['removed_volume_m3']:.4f}"}


def rows_of_validation(m):
    """The atmospheric comparisons of validation/."""
    sys.path.insert(0, str(ROOT / "validation"))
    import compare
    import comparison
    import validate
    split = [c for c in comparison.read_split() if c["kind"] == "measured"]
    for variant, options in VARIANTS.items():
        results = m.temporary / ("rows-" + "-".join(variant.replace(",", "").split()))
        results.mkdir(parents=True, exist_ok=True)
        for case, before in validate.runs(split):
            validate.calibrate(m.tdbd, case, results, before, options)
        for c in compare.compare(results, split):
            for load in c.loads:
                yield {"comparison": c.name, "law": c.law, "load": load.name, "break-out": variant, "mean error": f"{load.mean():.4f}",
                       "rms error": f"{load.rms():.4f}", "verdict": c.verdict()}


def measure(m):
    """Parts for --only: grooves.csv, neighbours.csv, bit.csv, rows.csv."""
    for file, rows in (("grooves.csv", grooves_of), ("neighbours.csv", neighbours_of), ("bit.csv", turning_bit), ("rows.csv", rows_of_validation)):
        if m.includes(file):
            m.write(file, rows(m))
