"""In place of figure 4.15: the walk over a part's facets to the exit of a vertex, with how often it took each branch."""

from figures import style
from figures.flow import Flow


def draw(inputs):
    rows = inputs.table("walk-activity")
    if rows is None:
        return style.only_words("walks to the exit")
    [n] = rows
    flow = Flow(2, 6)
    flow.action(0, 0, "vertex, path and update direction", str(n["queries"]))
    flow.decision(0, 1, "near the part's box?")
    flow.action(0, 2, "walk from the last facet, across\nthe edge that is missed most", str(n["tried"]))
    flow.decision(0, 3, "a facet where it leaves?")
    flow.action(0, 4, "facets up to a little beyond it")
    flow.action(0, 5, "exit, or not swept", f"{n['swept']} swept")
    flow.end(1, 1, "not swept", str(n["queries"] - n["tried"]))
    flow.action(1, 3, "first facet by the tree of boxes", str(n["tried"] - n["found"]))
    flow.action(1, 4, "search by the tree of boxes", str(n["tried"] - n["answered"]))
    for row, label in enumerate(("", "yes", "", f"yes: {n['found']}", f"enough: {n['answered']}")):
        flow.below(0, row, label)
    flow.beside(0, 1, "no")
    flow.beside(0, 3, "no")
    flow.beside(0, 4, "not enough")
    return flow.figure
