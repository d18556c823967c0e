"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv

HERE = Path(__file__).parent
GIVEN = ["us at 0.7 mm", "after 100 steps of the standard workload", "Asked were 250", "every 50 steps"]


def stated():
    walls, edges, memory = (read_csv(HERE / name) for name in ("walls.csv", "edges.csv", "memory.csv"))
    triangles, times = walls["triangles, thousand"], walls["CPU us a step, after (115 moves)"]
    yield "{:.0f} times the triangles", triangles[-1] / triangles[0]
    yield "change its time by {:.0f} %", 100.0 * (max(times) / min(times) - 1.0)
    yield "the finer the mesh, {:.1f} us at", edges["us a move"][edges["edges, mm"].index(0.7)]  # the last column of that name: after
    yield "Memory is {:.0f} bytes", *memory["bytes a triangle after 100 steps"]
    yield "of the standard workload, {:.0f} at most while", *memory["at most while the start is built"]
