"""Makes the tables and the figure of a study from `tables` and `[figure]` of its study.toml.

tables        file = "x.csv": the file unchanged; or rows = EXPRESSION and columns = [[HEADING, EXPRESSION of the row r], ...];
              caption: the text above it
[figure]      size = [WIDTH, HEIGHT] in inches, panels = [ROWS, COLUMNS] ([1, 1]), sharex = true
[[figure.axes]]   the arguments of matplotlib's axes.set (xlabel, ylim, xscale, ...), legend = {...}, and draw, a list of
              {of = TABLE, x = COLUMN, y = COLUMN, style = "o-", color = "BLUE", ...}: a line. A column that begins with "="
              is an expression, in which c("COLUMN") is a column of the table as an array
              {axhline = 0.0}, {axvline = EXPRESSION}, {axhspan = [LOW, HIGH]}
              {call = "NAME"}: the function NAME(axes) of study.py
              Any string that begins with "=" is an expression. Colours in capitals are those of figures/style.py.
tables() of study.py returns a text that follows the tables. figure() returns a figure and replaces [figure].
"""

from pathlib import Path

from study_tools import Table, markdown_table, read_text

OWN = ("of", "x", "y", "call", "axhline", "axvline", "axhspan")


def table_text(study, entry):
    """One table below its caption."""
    if "file" in entry:
        headings, *rows = read_text(study.folder / entry["file"])
        text = markdown_table(headings, rows)
    else:
        columns = entry["columns"]
        rows = [[study.value(cell, r=r) for _, cell in columns] for r in study.value(entry["rows"])]
        text = markdown_table([heading for heading, _ in columns], rows)
    return f"{entry['caption']}\n\n{text}" if "caption" in entry else text


def write_tables(study, out):
    """Writes OUT/table.md if the study has tables."""
    texts = [table_text(study, entry) for entry in study.plan.get("tables", [])]
    if own := study.function("tables"):
        texts.append(own())
    if texts:
        (Path(out) / "table.md").write_text("\n".join(texts), encoding="utf-8")


def colour(style, value):
    """A colour: a name of style.py in capitals, or a colour of matplotlib."""
    return getattr(style, value) if value.isupper() else value


def values(study, table, column):
    """A column of a table, or the value of an expression of its columns."""
    import numpy as np
    if not column.startswith("="):
        return table[column]
    return study.value(column[1:].strip(), t=table, c=lambda name: np.array(table[name]))


def draw(study, style, axes, entry):
    """One entry of `draw`."""
    options = {key: value for key, value in entry.items() if key not in OWN and not (key == "style" and "call" not in entry)}
    for key, value in options.items():
        if isinstance(value, str) and value.startswith("="):
            options[key] = study.value(value[1:].strip())
    if "color" in options:
        options["color"] = colour(style, options["color"])
    if "call" in entry:
        study.function(entry["call"])(axes, **options)
    elif line := next((name for name in ("axhline", "axvline") if name in entry), None):
        place = entry[line]
        getattr(axes, line)(study.value(place) if isinstance(place, str) else place, **options)
    elif "axhspan" in entry:
        axes.axhspan(*entry["axhspan"], **options)
    else:
        table = Table(study.value(entry.get("of", "[]")))
        axes.plot(values(study, table, entry["x"]), values(study, table, entry["y"]), *[entry[k] for k in ("style",) if k in entry],
                  **options)


def infinite(limits):
    """Limits, with None for "auto", because TOML has no None."""
    return [None if x == "auto" else x for x in limits]


def finish(axes, entry):
    """Labels, limits, scales and legend."""
    settings = {k: infinite(v) if k in ("xlim", "ylim") else v for k, v in entry.items() if k not in ("draw", "legend")}
    axes.set(**settings)
    if "legend" in entry:
        axes.legend(**entry["legend"])


def write_figure(study, out):
    """Writes OUT/figure.png: the figure of `[figure]`, or the one that figure() of study.py returns."""
    plan, own = study.plan.get("figure"), study.function("figure")
    if plan is None and own is None:
        return
    from figures import style
    if own:
        figure = own()
    else:
        import numpy as np
        figure, axes = style.panels(*plan.get("panels", [1, 1]), tuple(plan["size"]), sharex=plan.get("sharex", False))
        for one, entry in zip(np.ravel(axes), plan["axes"], strict=True):
            for line in entry.get("draw", []):
                draw(study, style, one, line)
            finish(one, entry)
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})
