#pragma once

#include <string>
#include <vector>

namespace tdbd::simulation {

enum class LineStyle { markers, dashed };

/// Points of one line; those with an x or y that is not positive are left out.
struct PlotLine {
  std::string label;
  std::vector<double> x, y;
  LineStyle style = LineStyle::markers;
};

/// A picture of lines over two logarithmic axes.
struct LogLogPlot {
  std::string title, x_label, y_label, legend_title;
  std::vector<PlotLine> lines;
};

/// As a self-contained SVG: ticks at 1, 2, 5 times powers of ten where the axis is short, at powers
/// of ten where it is long; a legend on the right. The same bytes for the same plot.
std::string to_svg(const LogLogPlot& plot);

}  // namespace tdbd::simulation
