"""layouts.py [-o DIR]: how the comparisons of whole bits depend on the layouts, which are assumptions of TDBD.

Repeats these comparisons with the layouts of layouts.toml in DIR/layouts (DIR: results/validation,
after scripts/validate). Writes DIR/layouts/layouts.csv and layouts.md: mean and rms error of each
comparison and law by layout."""

import csv
import re
import sys
import tomllib

import comparison
import validate

OURS = "ours"


def changed(text, keys):
    """Returns the text of a bit file with other values {"table.key": value} of existing keys."""
    left, table, lines = dict(keys), "", []
    for line in text.split("\n"):
        if heading := re.match(r"\[([\w.]+)\]", line):
            table = heading[1]
        key = re.match(r"(\w+) = ", line)
        if key and (place := f"{table}.{key[1]}") in left:
            value = left.pop(place)
            line = f"{key[1]} = " + (f'"{value}"' if isinstance(value, str) else str(value))
        lines.append(line)
    if left:
        raise comparison.Problem(f"layouts.toml: found {', '.join(left)}, expected keys that the bit files have")
    return "\n".join(lines)


def keys_of(layout, bit):
    """The changes of a bit: those for all bits, then those for longer prefixes of its name."""
    found = {}
    for start in sorted(layout["keys"], key=len):
        if bit.startswith(start):
            found |= layout["keys"][start]
    return found


def write_bits(folder, layout):
    folder.mkdir(parents=True, exist_ok=True)
    for file in sorted((comparison.HERE / "bits").glob("*.toml")):
        text = changed(file.read_text(encoding="utf-8"), keys_of(layout, file.stem))
        (folder / file.name).write_text(text, encoding="utf-8")


def other_bits(case, folder):
    """Options that replace the bits of a case by those in a folder."""
    bits = tomllib.loads((comparison.HERE / "cases" / f"{case}.toml").read_text(encoding="utf-8"))["bits"]
    return [word for name, file in bits.items() for word in ("--set", f"bits.{name}={folder / file.split('/')[-1]}")]


def whole_bits(split):
    """The comparisons of whole bits that are fitted to bits."""
    return [c for c in split if c["name"].startswith("bit-") and c["name"] != "bit-from-cutter"]


def rows(compared, layout):
    return [{"name": c.name, "law": c.law, "layout": layout, "mean_error": f"{load.mean():.4f}",
             "rms_error": f"{load.rms():.4f}", "verdict": c.verdict()} for c in compared for load in c.loads]


def with_layout(program, results, split, layout):
    """Computes the comparisons with other bits."""
    folder = results / "layouts" / layout["name"].replace(" ", "-")
    write_bits(folder / "bits", layout)
    for case, _ in validate.runs(split):
        validate.calibrate(program, case, folder, None, ["--cuts", str(results / "cuts"), *other_bits(case, folder / "bits")])
    return rows(comparison.read_all(split, folder, comparison.floors()), layout["name"])


def markdown(found):
    """Mean errors, one column per layout; bold where the verdict differs from that with the layout of TDBD."""
    layouts = list(dict.fromkeys(r["layout"] for r in found))
    lines = ["| comparison | law | " + " | ".join(layouts) + " |", "|---" * (2 + len(layouts)) + "|"]
    for name, law in dict.fromkeys((r["name"], r["law"]) for r in found):
        by = {r["layout"]: r for r in found if (r["name"], r["law"]) == (name, law)}
        cells = [f"{100 * float(r['mean_error']):+.0f} %" for r in by.values()]
        cells = [c if r["verdict"] == by[OURS]["verdict"] else f"**{c}**" for c, r in zip(cells, by.values())]
        lines.append(f"| {name} | {law} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def compare_layouts(program, results, names):
    split = whole_bits(validate.chosen(comparison.read_split(), names))
    found = rows(comparison.read_all(split, results, comparison.floors()), OURS)
    for layout in tomllib.loads((comparison.HERE / "layouts.toml").read_text(encoding="utf-8"))["layout"]:
        found += with_layout(program, results, split, layout)
    with (results / "layouts" / "layouts.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, found[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(found)
    text = markdown(found)
    (results / "layouts" / "layouts.md").write_text(text, encoding="utf-8")
    print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(validate.main(compare_layouts, __doc__))
