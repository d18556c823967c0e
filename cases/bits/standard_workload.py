#!/usr/bin/python3
"""Cutter table of the standard workload, the bit of cases/standard-workload.toml.

    cases/bits/standard_workload.py > cases/bits/standard.csv     write it
    cases/bits/standard_workload.py --check FILE                  exit 1 unless FILE is that table
    cases/bits/standard_workload.py core > cases/bits/core.csv    the same from r = 12 mm outwards: it
                                                                  leaves a core; --check knows it too

Profile in (r, z), mm, z down: a cone that falls at 15 degrees from the axis to r = 45, then one arc
of radius 52.15 on which the profile's angle (normal into the rock against the axis) goes from -15
to +70 degrees. 40 cutters at equal arc length, the first tip at r = 5. Cutter k = 0, 1, ... stands
on blade k mod 5, blades 72 degrees apart. On each blade every second cutter sits 7 mm farther back
along its track from the shoulder on (k >= 15), so that no two discs touch.
"""

import math
import pathlib
import sys

CUTTERS, BLADES = 40, 5
FIRST_RADIUS = {"standard": 5.0, "core": 12.0}  # mm
CONE_RADIUS, ARC_RADIUS = 45.0, 52.15  # mm
CONE_ANGLE, LAST_ANGLE = math.radians(-15.0), math.radians(70.0)
DIAMETER, BACK_RAKE = 13.4, 15.0  # mm, degrees
SET_BACK, FIRST_SET_BACK = 7.0, 15  # mm along the track; the first cutter that may sit back

CONE_LENGTH = CONE_RADIUS / math.cos(CONE_ANGLE)
ARC_CENTRE = CONE_RADIUS - ARC_RADIUS * math.sin(CONE_ANGLE)  # its radius r
CONE_DEPTH = -CONE_RADIUS * math.tan(CONE_ANGLE)  # from the profile's start on the axis
NOSE_DEPTH = CONE_DEPTH + ARC_RADIUS * (1.0 - math.cos(CONE_ANGLE))


def profile(s):
    """Radius, height above the nose tip (mm) and profile angle (rad) at arc length s from the axis."""
    if s <= CONE_LENGTH:
        return s * math.cos(CONE_ANGLE), NOSE_DEPTH + s * math.sin(CONE_ANGLE), CONE_ANGLE
    angle = CONE_ANGLE + (s - CONE_LENGTH) / ARC_RADIUS
    return ARC_CENTRE + ARC_RADIUS * math.sin(angle), ARC_RADIUS * (1.0 - math.cos(angle)), angle


def arc_length(bit, k):
    first = FIRST_RADIUS[bit] / math.cos(CONE_ANGLE)
    last = CONE_LENGTH + ARC_RADIUS * (LAST_ANGLE - CONE_ANGLE)
    return first + (last - first) * k / (CUTTERS - 1)


def zone(angle):
    return "cone" if angle <= CONE_ANGLE else "nose" if angle < math.radians(20.0) else "shoulder"


def row(bit, k):
    r, height, angle = profile(arc_length(bit, k))
    azimuth = 360.0 / BLADES * (k % BLADES)
    if k >= FIRST_SET_BACK and k // BLADES % 2 == 1:
        azimuth -= math.degrees(SET_BACK / r)
    return (f"{bit},{k + 1},{k % BLADES + 1},{zone(angle)},{DIAMETER:.3f},{r:.6f},{azimuth:.6f},"
            f"{height:.6f},{math.degrees(angle):.6f},{BACK_RAKE:.3f},0.000\n")


def table(bit):
    head = ("bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,"
            "back_rake_deg,side_rake_deg\n")
    return head + "".join(row(bit, k) for k in range(CUTTERS))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--check"] and len(sys.argv) == 3:
        file = pathlib.Path(sys.argv[2])
        if file.stem not in FIRST_RADIUS or file.read_text(encoding="utf-8") != table(file.stem):
            sys.exit(f"{file} is not the table that {sys.argv[0]} makes")
    elif len(sys.argv) == 1:
        sys.stdout.write(table("standard"))
    elif len(sys.argv) == 2 and sys.argv[1] in FIRST_RADIUS:
        sys.stdout.write(table(sys.argv[1]))
    else:
        sys.exit(__doc__)
