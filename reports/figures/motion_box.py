"""For figures 4.2 and 4.3: the motion box of a cutter, what the search finds in it, what was swept."""

from figures import style
from figures.one_step import STATES, Step, legend_below, name_planes, rz, xy


def draw(inputs):
    if inputs.table("one-step") is None:
        return style.only_words("one step of one cutter")
    step = Step(inputs.table("one-step"))
    figure, (above, section) = style.panels(1, 2, (10.4, 5.2))
    for axes, plane in ((above, xy), (section, rz)):
        step.draw_both(axes, plane)
        step.draw_vertices(axes, plane)
    step.draw_box(above)
    name_planes(above, section)
    handles = [above.scatter([], [], s=20, color=c, label=f"{w}: {(step.state == k).sum()}") for k, (w, c, _) in enumerate(STATES)]
    handles += above.plot([], [], color=style.GOLD, label="motion box, in x and y")
    handles += above.plot([], [], "--", color=style.GREY, label="cutter before the step")
    handles += above.plot([], [], color=style.BLACK, label="cutter after it")
    legend_below(figure, handles)
    return figure
