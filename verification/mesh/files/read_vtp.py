"""read_vtp.py FILE.vtp OUT.txt: writes what VTK's own reader finds, numbers in shortest digits."""

import sys

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def number(x):
    """Digits as fmt prints them: whole numbers without a point."""
    return str(int(x)) if x == int(x) else repr(x)


def fields(kind, data):
    for a in range(data.GetNumberOfArrays()):
        array = data.GetArray(a)
        for i in range(array.GetNumberOfTuples()):
            yield f"{kind} {array.GetName()} {number(array.GetTuple1(i))}"


reader = vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
if reader.GetErrorCode() != 0:
    sys.exit(f"{sys.argv[1]}: VTK reports error {reader.GetErrorCode()}")
mesh = reader.GetOutput()

lines = [f"point {' '.join(map(number, mesh.GetPoint(i)))}" for i in range(mesh.GetNumberOfPoints())]
for i in range(mesh.GetNumberOfCells()):
    cell = mesh.GetCell(i)
    lines.append("cell " + " ".join(str(cell.GetPointId(k)) for k in range(cell.GetNumberOfPoints())))
lines += fields("point_data", mesh.GetPointData())
lines += fields("cell_data", mesh.GetCellData())
with open(sys.argv[2], "w", encoding="utf-8") as out:
    out.write("\n".join(lines) + "\n")
