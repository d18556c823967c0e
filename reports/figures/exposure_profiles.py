"""Figure 3.8: exposure profiles, every cutter turned into one half-plane."""

from figures import bit_charts, bit_data, style


def draw_bits(bits):
    figure, panels = style.panels(len(bits), 1, (7.4, 4.4 * len(bits)), sharex=True, squeeze=False)
    for axes, bit in zip(panels[:, 0], bits):
        bit_charts.draw_outlines(axes, bit)
        bit_charts.half_plane(axes)
        bit_charts.show_cutters(axes, bit)
        bit_charts.blade_legend(axes, bit)
        axes.set_title(bit.name, loc="left", weight="bold")
    return figure


def draw(inputs):
    return draw_bits([bit_data.read(folder) for folder in inputs.folders()])
