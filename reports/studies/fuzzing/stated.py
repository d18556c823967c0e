"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

GIVEN = ["more than 1 GiB", "have up to 512 bytes (meshes, tapes), 1 or 2 KiB"]
MESHES = ("obj", "off", "ply_binary", "ply_text", "stl_binary", "stl_text")


def stated():
    rows = read_rows(Path(__file__).parent / "executions.csv")
    cost = {row["reader"]: 1e3 * row["seconds"] / row["executions"] for row in rows}  # ms
    yield "A case takes {:.0f} ms and a bit {:.0f} ms", cost["case"], cost["bit"]
    meshes = [cost[name] for name in MESHES]
    yield "a mesh takes {:.1f} to {:.1f} ms", min(meshes), max(meshes)
