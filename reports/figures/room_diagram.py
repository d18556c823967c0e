"""The modules of src and their sub-folders: what each declares, and which includes which. Read from the code."""

from matplotlib.patches import FancyArrowPatch, Rectangle

from figures import headers, style
from figures.class_diagram import POINTS, wrapped

WIDTH, GAP, LINE, ROW_GAP = 3.0, 0.5, 0.172, 0.6  # inches


def room_of(path):
    return path.split("/")[0]


def sub_folder_of(path):
    return "/".join(path.split("/")[1:-1]) or "."


def needed(texts):
    """{module: modules that its files include}."""
    found = {room_of(path): set() for path in texts}
    for path, text in texts.items():
        found[room_of(path)] |= {room_of(i) for i in headers.includes(text) if room_of(i) in found} - {room_of(path)}
    return found


def closure(needs, room):
    """All modules that a module includes, directly or not."""
    reached, to_read = set(), [room]
    while to_read:
        to_read += (more := needs[to_read.pop()] - reached)
        reached |= more
    return reached


def direct(needs):
    """Without the includes that follow from others: an arrow to a module that another arrow leads to anyway."""
    return {room: {o for o in others if not any(o in closure(needs, between) for between in others - {o})} for room, others in needs.items()}


def level(needs, room):
    """The number of levels of modules above it."""
    return 1 + max((level(needs, user) for user, others in needs.items() if room in others), default=-1)


def lines_of(room, texts):
    own = {path: headers.read(text) for path, text in texts.items() if room_of(path) == room and path.endswith(".hpp")}
    types, functions = (sum(len(getattr(h, what)) for h in own.values()) for what in ("types", "functions"))
    counted = {}
    for path in own:
        counted[sub_folder_of(path)] = counted.get(sub_folder_of(path), 0) + 1
    folders = [f"{name} {n}" if name != "." else f"itself {n}" for name, n in counted.items()]
    return [f"{len(own)} headers, {types} types, {functions} functions", *wrapped(folders, WIDTH - 0.2)]


def draw_room(axes, room, lines, x, top):
    height = LINE * (len(lines) + 2.6)
    axes.add_patch(Rectangle((x, top - height), WIDTH, height, facecolor="#eef2f6", edgecolor=style.GREY, linewidth=0.8, zorder=2))
    axes.text(x + 0.1, top - 1.4 * LINE, f"src/{room}", fontsize=11, weight="bold", color=style.BLACK, zorder=3)
    for k, line in enumerate(lines):
        axes.text(x + 0.1, top - (k + 2.5) * LINE, line, fontsize=POINTS, color=style.BLACK if k else style.GREY, zorder=3)
    return height


def draw(inputs):
    texts = {path.removeprefix("src/"): text for path, text in inputs.texts().items()}
    needs = needed(texts)
    rows = {}
    for room in sorted(needs):
        rows.setdefault(level(needs, room), []).append(room)
    wide = max(len(r) for r in rows.values()) * (WIDTH + GAP) + GAP
    lines = {room: lines_of(room, texts) for room in needs}
    tall = {k: max(LINE * (len(lines[r]) + 2.6) for r in row) for k, row in rows.items()}
    height = sum(tall.values()) + ROW_GAP * len(rows)
    figure = style.Figure(figsize=(wide, height))
    axes = figure.add_axes([0, 0, 1, 1])
    axes.set(xlim=(0, wide), ylim=(-height, 0))
    axes.set_axis_off()
    ends, top, arrows = {}, -0.5 * ROW_GAP, direct(needs)
    for k in sorted(rows):
        def middle_of_users(room):
            users = [ends[user][0] for user, others in arrows.items() if room in others]
            return sum(users) / max(len(users), 1)
        start = 0.5 * (wide - len(rows[k]) * (WIDTH + GAP) + GAP)
        for n, room in enumerate(sorted(rows[k], key=lambda r: (middle_of_users(r), r))):
            x = start + n * (WIDTH + GAP)
            ends[room] = (x + 0.5 * WIDTH, top, top - draw_room(axes, room, lines[room], x, top))
        top -= tall[k] + ROW_GAP
    for room, others in arrows.items():
        for other in sorted(others):
            axes.add_patch(FancyArrowPatch((ends[room][0], ends[room][2]), (ends[other][0], ends[other][1]), arrowstyle="-|>",
                                           mutation_scale=9, linewidth=0.9, color=style.RED, shrinkA=0, shrinkB=0, zorder=1))
    return figure
