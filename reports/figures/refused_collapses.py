"""Figure 4.18: triangles that cannot be deleted, one sheet for each reason of refusal."""

from figures import style
from figures.sheets import draw_sheet

WORDS = {"boundary": "boundary: an end is on it", "topology": "topology: the sheet would be pinched",
         "normal": "normal: a triangle would turn over", "overhang": "overhang: rock would hang over",
         "too_long": "too long: an edge would be", "too_short": "too short: an edge would be",
         "quality": "quality: a triangle would be worse", "volume": "volume: too much would change",
         "distance": "distance: the surface would go too far", "ridge": "ridge: it would be cut"}


def draw(inputs):
    if inputs.table("refusals") is None:
        return style.only_words("refused collapses")
    table = inputs.table("refusals")
    columns = 4
    rows = -(-len(table) // columns)
    figure, frames = style.panels(rows, columns, (11.6, 3.0 * rows), squeeze=False)
    for axes in frames.ravel():
        axes.set_axis_off()
    for axes, row in zip(frames.ravel(), table):
        draw_sheet(axes, row)
        axes.set_title(WORDS.get(row["stage"], row["stage"]))
    return figure
