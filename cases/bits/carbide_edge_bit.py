"""carbide_edge_bit.py TDBD OUT.stl: writes the bit of cases/bits/carbide-edge.toml as a drawing program would.

A text STL in mm of a small bit with six worn cutters, every part a named solid. The program makes the
parts from a table; this script divides each carbide body behind its diamond table into the edge that
supports the table and the rest. The numbers are rounded to 1e-6 mm.
"""

import csv
import io
import pathlib
import sys

import numpy as np

from outside_bit import solids_stl

TABLE_MM, EDGE_MM = 2.0, 3.0  # thickness of the diamond table; of the carbide edge behind it
TABLE = """bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,side_rake_deg,wear_mm
E,1,1,cone,16,5,0,6,-15,15,0,1
E,2,2,cone,16,15,180,3.3,-15,15,0,1
E,3,1,nose,16,25,10,1,0,15,0,1
E,4,2,nose,16,34,190,1.5,15,15,0,1
E,5,1,shoulder,16,42,20,5,45,15,0,1
E,6,2,shoulder,16,47,200,11,70,15,0,1
"""
BIT = f'''name = "carbide-edge"
table = "table.csv"
gage_diameter = "100 mm"
[cutters]
table_thickness = "{TABLE_MM} mm"
length = "13 mm"
[mesh]
rim_segments = 32
'''


def solids_of(text):
    """{name: triangles in mm, each three corners}."""
    solids, name = {}, None
    for line in text.splitlines():
        word, *rest = line.split()
        if word == "solid":
            name = " ".join(rest).removesuffix(" unit=mm")
            solids[name] = []
        elif word == "vertex":
            solids[name].append([float(x) for x in rest])
    return {name: np.array(corners).reshape(-1, 3, 3) for name, corners in solids.items()}


def frame_of(row):
    """Tip (mm) and unit axis out of the face of a cutter without side rake."""
    r, h = float(row["r_tip_mm"]), float(row["h_tip_mm"])
    phi, theta, rake = (np.radians(float(row[k])) for k in ("phi_deg", "profile_angle_deg", "back_rake_deg"))
    tip = np.array([r * np.cos(phi), r * np.sin(phi), -h])
    motion = np.array([-np.sin(phi), np.cos(phi), 0.0])
    normal = np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])
    return tip, np.cos(rake) * motion + np.sin(rake) * normal


def half(triangles, point, axis):
    """The part of a convex solid on the side of the plane to which the axis points, closed."""
    kept, cap = [], []
    for corners in triangles:
        above = (corners - point) @ axis
        polygon = []
        for k in range(3):
            a, b, da, db = corners[k], corners[(k + 1) % 3], above[k], above[(k + 1) % 3]
            if da >= 0.0:
                polygon.append(a)
            if da * db < 0.0:
                cut = a + da / (da - db) * (b - a)
                polygon.append(cut)
                cap.append(cut)
        kept += [(polygon[0], polygon[k], polygon[k + 1]) for k in range(1, len(polygon) - 1)]
    cap = np.unique(np.round(cap, 6), axis=0)
    middle = cap.mean(axis=0)
    first = np.cross(axis, cap[0] - middle)
    second = np.cross(axis, first)
    cap = cap[np.argsort(np.arctan2((cap - middle) @ second, (cap - middle) @ first))[::-1]]
    kept += [(middle, cap[k - 1], cap[k]) for k in range(len(cap))]
    return np.array(kept)


def written(solids):
    lines = []
    for name, triangles in solids.items():
        lines.append(f"solid {name}")
        for corners in triangles:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex " + " ".join(f"{x + 0.0:.6f}" for x in np.round(c, 6)) for c in corners]
            lines += ["endloop", "endfacet"]
        lines.append(f"endsolid {name}")
    return "\n".join(lines) + "\n"


def main(program, out):
    solids = solids_of(solids_stl(program, TABLE, BIT))
    for row in csv.DictReader(io.StringIO(TABLE)):
        tip, axis = frame_of(row)
        body = solids.pop(f"cutter-{row['cutter']}/body")
        behind = tip - (TABLE_MM + EDGE_MM) * axis
        solids[f"cutter-{row['cutter']}/carbide-edge"] = half(body, behind, axis)
        solids[f"cutter-{row['cutter']}/body"] = half(body, behind, -axis)
    pathlib.Path(out).write_text(written(solids), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
