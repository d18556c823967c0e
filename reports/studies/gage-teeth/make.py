"""make.py OUT: the table of this study, from walls.csv."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table, read_rows  # noqa: E402

MOTION = {"normal": "each vertex along the tooth's normal there", "row": "all along the row's normal in the journal's plane",
          "down": "straight down", "horizontal": "straight outwards"}


def main(out):
    rows = [[row["rule"], MOTION[row["rule"]], f"{row['worst quality']:.2f}"] for row in read_rows(HERE / "walls.csv")]
    out.mkdir(parents=True, exist_ok=True)
    (out / "table.md").write_text(markdown_table(["`update.gage_teeth`", "vertices move", "worst quality"], rows), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
