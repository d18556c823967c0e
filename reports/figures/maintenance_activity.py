"""In place of figures 4.17 and 4.20: how often maintenance took each branch of its activity, over long runs."""

import numpy as np

from figures import results, style


def in_words(key):
    return key.replace("refused_", "refused: ").replace("_", " ")


def draw(inputs):
    runs = [results.summary(folder) for folder in inputs.folders()]
    keys = [k for k in runs[0]["maintenance"] if any(run["maintenance"].get(k) for run in runs)]
    keys.sort(key=lambda k: (k.startswith("refused"), k))
    figure, axes = style.panels(1, 1, (7.6, 0.7 + 0.42 * len(keys)))
    height = 0.8 / len(runs)
    for k, (run, colour) in enumerate(zip(runs, (style.BLUE, style.RED, style.GREEN))):
        counts = np.array([run["maintenance"].get(key, 0) for key in keys])
        places = np.arange(len(keys)) + (k - 0.5 * (len(runs) - 1)) * height
        axes.barh(places, counts, height, color=colour, label=f"{run['title']}, {run['revolutions']:.3g} revolutions")
        for place, count in zip(places, counts):
            axes.annotate(str(count), (max(count, 1), place), xytext=(3, 0), textcoords="offset points", va="center", fontsize=7)
    axes.set_yticks(np.arange(len(keys)), [in_words(k) for k in keys])
    axes.invert_yaxis()
    axes.set(xscale="log", xlabel="count over the whole run", xlim=(0.8, 4 * max(max(r["maintenance"].values()) for r in runs)))
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=len(runs))
    return figure
