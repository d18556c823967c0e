"""The coupled run compared with its twins: the output of the tests of verification/simulation/coupled."""

COLUMNS = ["situation", "quantity", "program", "uncertainty", "twin", "uncertainty of the twin", "difference"]


def rows_of(lines):
    """The rows that the tests print, each with the name of its test."""
    test = ""
    for line in lines:
        if line.startswith("[ RUN      ]"):
            test = line.split("] ")[1].split(".")[1].replace("_", " ")
        if line.startswith("row;"):
            *words, scale = line.split(";")[1:]
            row = dict(zip(COLUMNS, [test, *words], strict=True))
            combined = float(row["uncertainty"]) + float(row["uncertainty of the twin"])
            yield row | {"combined uncertainty over the scale": f"{combined / float(scale):.2g}"}


def measure(m):
    m.write("coupled-twin.csv", rows_of(m.output("verification/simulation/verify_coupled_twin", codes=(0, 1)).splitlines()))
