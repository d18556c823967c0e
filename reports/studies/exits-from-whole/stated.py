"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).resolve().parent
GIVEN = ["three revolutions long (1.5 s or 3 revolutions)", "with 0.7 times the edge length", "a millionth changed the rate by 6 %"]
LED = ("standard-workload", "bit-b-steady", "bit-a-steady", "bit-r-rolling", "bit-b-whirl")
SAME = ("removed volume, cm3", "volume of a cutter, greatest change", "section area, mm2", "section area of a cutter, greatest change",
        "worst quality", "1 % quality", "bisections", "triangles at the end")
LOADS = ("weight on bit, kN", "torque on bit, N m", "rate of penetration, m/h")
WHOLE, FINER, NUDGED = "change from parts to whole", "change with 0.7 times the edges", "change with 1.000001 times the edges"
CUTTER, MEAN, GREATEST = "volume of a cutter, greatest change", "distance of surfaces, mean, mm", "distance of surfaces, greatest, mm"
CONTACT = "contact area of a part, greatest change"


def table(file):
    return {(row["case"], row["quantity"]): row for row in read_rows(HERE / file)}


def size(cell):
    """Of a change, in percent, or of a distance, in mm."""
    return abs(float(cell.removesuffix(" %")))


def greatest(found, cases, quantities, change):
    return max(size(found[key][change]) for key in ((c, q) for c in cases for q in quantities) if key in found)


def range_of_kind(kind, share):
    """Least and greatest share of a kind of part among the cases whose cutters have chamfers."""
    rows = read_rows(HERE / "owners.csv")
    chamfered = {row["case"] for row in rows if row["kind of part"] == "chamfer"}
    shares = [row[share] for row in rows if row["kind of part"] == kind and row["case"] in chamfered]
    return min(shares), max(shares), chamfered


def stated():
    found, nudged = table("differences.csv"), table("rounding.csv")
    yield "at most {:.0e} mm apart at the end", greatest(found, LED, [GREATEST], WHOLE)
    yield "differ by at most {:.0e}, relative; contact areas of parts by {:.2f} %", greatest(found, LED, SAME, WHOLE) / 100.0, greatest(found, LED, [CONTACT], WHOLE)
    yield from of_drilling(found)
    *faces, chamfered = range_of_kind("face", "share by parts, %")
    yield "the face has {:.0f} to {:.0f} % of it", *faces
    yield "the chamfer has {:.0f} to {:.0f} %", *range_of_kind("chamfer", "share by whole, %")[:2]
    gone = [size(found[case, "moves a step"][WHOLE]) for case in chamfered]
    yield "{:.0f} to {:.0f} % of the moves go away", min(gone), max(gone)
    yield from of_whirl(found, nudged)


def of_drilling(found):
    def of(quantities, change):
        return greatest(found, ["drill-bit-b"], quantities, change)
    yield "are {:.4f} mm apart in the mean ({:.3f} mm", of([MEAN], WHOLE), of([MEAN], FINER)
    yield "rate of penetration within {:.2f} % ({:.1f} %)", of(LOADS, WHOLE), of(LOADS, FINER)
    yield "volumes of cutters within {:.3f} % ({:.1f} %)", of([CUTTER], WHOLE), of([CUTTER], FINER)
    yield "up to {:.1f} mm apart, where", of([GREATEST], WHOLE)
    yield "with the finer mesh up to {:.1f} mm", of([GREATEST], FINER)
    yield "Contact areas of its parts change by up to {:.0f} %", of([CONTACT], WHOLE)
    yield "they change by up to {:.0f} % and their sum by {:.0f} %", of([CONTACT], FINER), of(["contact area, mm2"], FINER)


def of_whirl(found, nudged):
    def three(rows, change):
        return [size(rows["drill-bit-b-whirl", quantity][change]) for quantity in (LOADS[-1], CUTTER, MEAN)]
    yield "differs by {:.2f} %, the volume of a cutter by up to {:.1f} %, the surfaces by {:.2f} mm", *three(found, WHOLE)
    yield "change them by {:.2f} %, {:.1f} % and {:.2f} mm", *three(nudged, NUDGED)
    yield "the finer mesh by {:.1f} %, {:.1f} % and {:.2f} mm", *three(found, FINER)
    places = found["drill-bit-b-whirl", GREATEST]
    yield "at single places by {:.1f} mm ({:.1f} mm). Before", size(places[WHOLE]), size(places[FINER])
