"""How the models of chapter 2 look in the figures that compare them."""

from figures import style

# model: (colour, marker)
LOOKS = {
    "tdbd": (style.BLACK, "o"),
    "warren-sinor": (style.GREY, "x"),
    "behr": (style.RED, "^"),
    "glowka": (style.PURPLE, "D"),
    "langeveld": (style.BLUE, "v"),
    "hanson-hansen": (style.GREEN, "s"),
    "briggs": (style.RED, "^"),
    "winters": (style.GOLD, "P"),
    "ma-azar": (style.GREY, "1"),
    "ma-zhou-deng": (style.BLUE, "v"),
    "huang-cawthorne-1": (style.PURPLE, "D"),
    "huang-cawthorne-2": (style.SKY, "<"),
    "sheppard-lesage": (style.GREY, "x"),
}
OTHER = (style.SKY, "*")


def look(model):
    """Keywords of plot() for a model's points."""
    colour, marker = LOOKS.get(model, OTHER)
    return {"color": colour, "marker": marker, "markersize": 6 if model == "tdbd" else 4, "fillstyle": "none"}


def title(results, model):
    """A model's name for readers, from the first run that has it."""
    for runs in results.values():
        for _, result in runs:
            if model in result.titles:
                return result.titles[model]
    return model


def legend(axes, what):
    """A legend; where nothing was drawn, a word instead."""
    if axes.get_legend_handles_labels()[1]:
        axes.legend()
    else:
        style.say_missing(axes, what)
