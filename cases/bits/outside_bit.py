"""outside_bit.py TDBD OUT.stl: writes the bit of cases/bits/outside.toml as a drawing program would.

A text STL in mm of a small bit with six cutters, every part a named solid. The program
itself makes the parts from a table and coarsens the body; the numbers are rounded to 1e-6 mm.
"""

import pathlib
import subprocess
import sys
import tempfile

TABLE = """bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,side_rake_deg
O,1,1,cone,16,5,0,6,-15,15,0
O,2,2,cone,16,15,180,3.3,-15,15,0
O,3,1,nose,16,25,10,1,0,15,0
O,4,2,nose,16,34,190,1.5,15,15,0
O,5,1,shoulder,16,42,20,5,45,15,0
O,6,2,shoulder,16,47,200,11,70,15,0
"""
BIT = 'name = "outside"\ntable = "table.csv"\ngage_diameter = "100 mm"\n[mesh]\nrim_segments = 32\n'


def rounded(line):
    """A line without the unit, which CAD programs do not write."""
    word, *numbers = line.removesuffix(" unit=mm").split()
    if word != "vertex":
        return line.removesuffix(" unit=mm").strip()
    return " ".join([word, *(f"{float(x) + 0.0:.6f}" for x in numbers)])


def solids_stl(program, table, bit):
    """The STL file, in mm, of a bit from a table with its body coarsened, as text."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "table.csv").write_text(table, encoding="utf-8")
        (folder / "bit.toml").write_text(bit, encoding="utf-8")

        def tdbd(*arguments):
            subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

        tdbd("bit", folder / "bit.toml", "-o", folder / "whole")
        tdbd("mesh", folder / "whole/bit.stl", "--grade", "--only", "bit-body", "--edge", "12 mm", "--face", "30 mm", "--deviation", "0.5 mm", "-o",
             folder / "coarse.stl")
        return (folder / "coarse.stl").read_text(encoding="utf-8")


def main(program, out):
    lines = solids_stl(program, TABLE, BIT).splitlines()
    pathlib.Path(out).write_text("\n".join(map(rounded, lines)) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
