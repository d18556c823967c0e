"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["60 to 75 degrees", "Here 60 and 70 degrees", "and 75 degrees as the end", "(Int. J. Rock Mech. Min. Sci. 9, 1972, 355)",
         "(Energies 13, 2020, 4496)", "below 1 stands", "With cracks at 60 degrees", "With cracks at 75 degrees", "A face of 13 mm at a depth of 3 mm", "edges of 0.5 mm", "edges from 2 mm",
         "edges of 1 mm", "steps of 2 ms to 0.5 ms", "spacing of 9 mm", "at 70 degrees. A law", "energy of 100 MPa", "at 5 mm a turn",
         "breaks out at 60 degrees", "% at 70 degrees", "% at 75 degrees", "edges of 2 mm give", "With 0.3 of the depth",
         "off by up to 1.1 % of the area"]


def groove(rows, edge, step, broken):
    return [r for r in rows if r["edge, mm"] == edge and r["step, ms"] == step and (r["angle, degrees"] > 0.0) == broken]


def worst(rows, name="error"):
    return max(abs(r[name]) for r in rows)


def stated():
    rows = read_rows(HERE / "grooves.csv")
    beside = [r for r in groove(rows, 0.5, 2.0, True)]
    yield "within {:.2f} % with break-out", 100.0 * worst(beside)
    yield "within {:.2f} % without any", 100.0 * worst(groove(rows, 0.5, 2.0, False))
    growth = max(abs(r["area that leaves, mm2"] / s["area that leaves, mm2"] - 1.0) for r, s in
                 zip(groove(rows, 1.0, 0.5, False) + groove(rows, 1.0, 0.5, True),
                     groove(rows, 1.0, 2.0, False) + groove(rows, 1.0, 2.0, True), strict=True))
    yield "by {:.2f} % of the area", 100.0 * growth
    yield "exact to {:.0e} where", worst([r for r in rows if r["ahead share"] == 0.0], "its error")
    yield "it is within {:.1f} %.", 100.0 * worst([r for r in rows if r["ahead share"] > 0.0], "its error")
    second = {r["angle, degrees"]: r for r in read_rows(HERE / "neighbours.csv") if r["spacing, mm"] == 9.0}
    yield "it is {:.1f} mm2 without", second[0.0]["section of the second groove, mm2"]
    yield "and {:.1f} mm2 with cracks", second[70.0]["section of the second groove, mm2"]
    yield "spends {:.1f} MPa", second[70.0]["specific energy, MPa"]
    bit = {(r["angle, degrees"], r["ahead share"], r["edge, mm"]): r for r in read_rows(HERE / "bit.csv")}
    share = {angle: 100.0 * bit[angle, 0.0, 1.0]["share broken out"] for angle in (60.0, 70.0, 75.0)}
    yield "Of that, {:.1f} % breaks", share[60.0]
    yield "{:.1f} % at 70", share[70.0]
    yield "and {:.1f} % at 75", share[75.0]
    weight = [bit[angle, 0.0, 1.0]["weight, N"] for angle in (0.0, 60.0, 70.0, 75.0)]
    yield "from {:.0f} N to {:.0f} N, {:.0f} N and {:.0f} N", *weight
    spread = max(abs(bit[a, 0.0, 2.0]["weight, N"] / bit[a, 0.0, 1.0]["weight, N"] - 1.0) for a in (0.0, 60.0, 70.0, 75.0))
    yield "the same within {:.1f} %", 100.0 * spread
    torque = [bit[70.0, 0.3, edge]["torque, N m"] for edge in (1.0, 2.0)]
    yield "changes by {:.0f} % between", 100.0 * abs(torque[0] - torque[1]) / torque[1]
    yield from rows_of_validation()


ORDER = ["within the floor", "within 2 floors", "fails"]


def rows_of_validation():
    rows = {}
    for r in read_rows(HERE / "rows.csv"):
        rows.setdefault((r["comparison"], r["law"], r["load"]), {})[r["break-out"]] = r
    yield "The {:.0f} rows of", float(len(rows))
    chips = "beside, 60 degrees, half ahead"
    moves = [abs(float(r[chips]["mean error"]) - float(r["none"]["mean error"])) for key, r in rows.items() if key[0].startswith("cutter")]
    yield "by at most {:.1f} % of the load", 100.0 * max(moves)
    berea = rows["bit-granite-to-berea", "hanson-hansen", "wob"]
    yield "from {:.1f} % to {:.1f} %.", *(100.0 * float(berea[v]["mean error"]) for v in ("none", "beside, 60 degrees"))
    yield "error falls to {:.1f} %", 100.0 * float(berea["beside, 75 degrees"]["mean error"])
    better, worse = {}, {}
    for variant in ("beside, 60 degrees", "beside, 75 degrees", chips):
        changes = [ORDER.index(r[variant]["verdict"]) - ORDER.index(r["none"]["verdict"]) for r in rows.values()]
        better[variant], worse[variant] = (float(sum(c < 0 for c in changes)), float(sum(c > 0 for c in changes)))
    assert better["beside, 60 degrees"] == worse["beside, 60 degrees"] == better["beside, 75 degrees"] == 0.0
    yield "and {:.0f} row gets a worse", worse["beside, 75 degrees"]
    yield "ahead, {:.0f} rows get a better", better[chips]
    yield "and {:.0f} a worse", worse[chips]
