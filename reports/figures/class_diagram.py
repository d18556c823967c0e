"""In place of the thesis's class diagrams: the types and functions that the headers of TDBD declare, read from the code."""

from dataclasses import dataclass

from matplotlib.font_manager import FontProperties
from matplotlib.patches import FancyArrowPatch, Rectangle
from matplotlib.textpath import text_to_path

from figures import headers, style

COLUMNS, WIDTH, GAP = 3, 3.05, 0.12  # in a row; inches
LINE, POINTS = 0.172, 8.8  # inches; as large as the text of the page, which shows the picture a little smaller
INDENT = 4 * " "
MARGIN, HEAD = 0.55, 0.3  # on the right, for arrows; above the boxes of a folder
TITLE, FILE, FIELD, OWN, FUNCTION = (
    {"weight": "bold", "color": style.BLACK}, {"color": style.GREY}, {"color": style.BLACK}, {"color": style.BLUE},
    {"color": style.GREEN, "style": "italic"})


@dataclass
class Box:
    """A header: lines of text with their looks; None is a rule across the box."""

    lines: list

    def height(self):
        return LINE * (sum(1 if line else 0.35 for line in self.lines) + 0.7)


def width_of(text):
    """Inches."""
    return text_to_path.get_text_width_height_descent(text, FontProperties(size=POINTS), ismath=False)[0] / 72


def shortened(text, width):
    """The text, or as much of it as fits."""
    if width_of(text) <= width:
        return text
    while width_of(text + "...") > width:
        text = text[:-1]
    return text + "..."


def wrapped(words, width):
    lines = [""]
    for word in words:
        longer = f"{lines[-1]}, {word}" if lines[-1] else word
        if lines[-1] and width_of(longer) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def grouped(fields):
    """(names, type): neighbours of one type together."""
    found = []
    for name, of in fields:
        if found and found[-1][1] == of:
            found[-1][0].append(name)
        else:
            found.append(([name], of))
    return found


def field_lines(fields, names, width):
    for together, of in grouped(fields):
        look = OWN if mentions(of, names) else FIELD
        words = [*together[:-1], f"{together[-1]}: {of}"] if together[-1] else f"= {of}".split(", ")
        first, *more = wrapped(words, width - width_of(f"|{INDENT}|"))
        yield from ((shortened(line, width), look) for line in [first, *(INDENT + m for m in more)])


def mentions(text, names):
    """Whether a field's type names one of the types in the picture."""
    return any(word.split("::")[-1] in names for word in headers.words(text))


def lines_of(path, header, names):
    """The lines in the box of a header."""
    width = WIDTH - 0.16
    lines = [(path, FILE)]
    for found in header.types:
        lines += [None, (f"{found.name}" + {"enum": "  (enum)", "using": "  (alias)"}.get(found.kind, ""), TITLE)]
        if found.kind == "enum":
            lines += [(line, FIELD) for line in wrapped([name for name, _ in found.fields], width)]
        else:
            lines += field_lines(found.fields, names, width)
    if header.functions:
        lines += [None] + [(line, FUNCTION) for line in wrapped([f"{f}()" for f in header.functions], width)]
    return lines


def folder_of(path):
    return path.rsplit("/", 1)[0]


def folders(read):
    """{folder: paths}, so that each includes only those after it."""
    found = {}
    for path in sorted(read):
        found.setdefault(folder_of(path), []).append(path)
    used = {f: {folder_of(i) for p in paths for i in read[p].included if folder_of(i) in found} - {f} for f, paths in found.items()}
    order = []
    while len(order) < len(found):
        order.append(min(f for f in found if f not in order and not any(f in used[o] for o in found if o not in order)))
    return {f: found[f] for f in order}, used


def columns_of(boxes):
    """The boxes in columns: each goes to the shortest, the highest first."""
    columns, heights = [[] for _ in range(COLUMNS)], [0.0] * COLUMNS
    for box in sorted(boxes, key=lambda b: -b.height()):
        k = heights.index(min(heights))
        columns[k].append(box)
        heights[k] += box.height() + GAP
    return columns, max(heights)


def draw_box(axes, box, x, y):
    """y is the box's top."""
    height = box.height()
    axes.add_patch(Rectangle((x, y - height), WIDTH, height, facecolor="white", edgecolor=style.GREY, linewidth=0.7))
    y -= 0.35 * LINE
    for line in box.lines:
        if line is None:
            y -= 0.35 * LINE
            axes.plot([x, x + WIDTH], [y + 0.1 * LINE] * 2, color="0.85", linewidth=0.6)
            continue
        y -= LINE
        axes.text(x + 0.08, y + 0.2 * LINE, line[0], fontsize=POINTS, **line[1])


def draw_folder(axes, name, columns, top, height):
    whole = COLUMNS * (WIDTH + GAP) + GAP
    axes.add_patch(Rectangle((0, top - height), whole, height, facecolor="#eef2f6", edgecolor="none"))
    axes.text(GAP, top - 0.21, f"src/{name}", fontsize=11, weight="bold", color=style.BLACK)
    for k, column in enumerate(columns):
        y = top - HEAD
        for box in column:
            draw_box(axes, box, GAP + k * (WIDTH + GAP), y)
            y -= box.height() + GAP


def draw_includes(axes, places, used):
    """Arrows on the right from a folder to those that its headers include."""
    right = COLUMNS * (WIDTH + GAP) + GAP
    for folder, others in used.items():
        for other in sorted(others):
            start, end = places[folder], places[other]
            axes.add_patch(FancyArrowPatch((right, start - 0.14), (right, end + 0.10), arrowstyle="-|>", mutation_scale=8, linewidth=0.9,
                                           color=style.RED, connectionstyle=f"arc3,rad={-min(0.45, 0.9 / abs(start - end)):.3f}"))


def draw(inputs):
    read = {path.removeprefix("src/"): headers.read(text) for path, text in inputs.texts().items()}
    names = {t.name.split("::")[-1] for h in read.values() for t in h.types}
    order, used = folders(read)
    parts, height = [], 0.0
    for folder, paths in order.items():
        boxes = [Box(lines_of(p.rsplit("/", 1)[1], read[p], names)) for p in paths]
        columns, tall = columns_of(boxes)
        parts.append((folder, columns, height, tall + HEAD))
        height += tall + HEAD + GAP
    wide = COLUMNS * (WIDTH + GAP) + GAP + (MARGIN if len(parts) > 1 else 0.0)
    figure = style.Figure(figsize=(wide, height))
    axes = figure.add_axes([0, 0, 1, 1])
    axes.set(xlim=(0, wide), ylim=(-height, 0))
    axes.set_axis_off()
    for folder, columns, top, tall in parts:
        draw_folder(axes, folder, columns, -top, tall)
    draw_includes(axes, {folder: -(top + 0.5 * tall) for folder, _, top, tall in parts}, used)
    return figure
