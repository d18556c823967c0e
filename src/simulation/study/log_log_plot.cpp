#include "simulation/study/log_log_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace tdbd::simulation {
namespace {

constexpr double left = 84, right = 560, top = 48, bottom = 440, width = 860, height = 500;

/// Colours that the colour-blind tell apart (Okabe and Ito).
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                             "#e69f00", "#56b4e9", "#8c564b", "#000000"};

/// An axis in powers of ten, over the pixels from `start` to `end`.
struct Axis {
  double lo = 0.0, hi = 1.0, start = 0.0, end = 1.0;

  double at(double value) const {
    return start + (std::log10(value) - lo) / (hi - lo) * (end - start);
  }
};

bool is_drawn(const PlotLine& line, std::size_t i) {
  return line.x[i] > 0.0 && line.y[i] > 0.0 && std::isfinite(line.x[i]) && std::isfinite(line.y[i]);
}

/// Around all values that are drawn, with a little air.
Axis axis_around(const LogLogPlot& plot, std::vector<double> PlotLine::*values, double start,
                 double end) {
  double lo = 1e300, hi = 1e-300;
  for (const PlotLine& line : plot.lines)
    for (std::size_t i = 0; i < line.x.size(); ++i)
      if (is_drawn(line, i)) {
        lo = std::min(lo, (line.*values)[i]);
        hi = std::max(hi, (line.*values)[i]);
      }
  if (lo > hi) lo = hi = 1.0;
  const double air = std::max(0.1, 0.04 * std::log10(hi / lo));
  return {std::log10(lo) - air, std::log10(hi) + air, start, end};
}

/// Powers of ten and, where the axis spans few, 2 and 5 times them.
std::vector<double> ticks(const Axis& axis) {
  const double span = axis.hi - axis.lo;
  const int stride = std::max(1, static_cast<int>(span / 12.0));
  std::vector<double> values;
  for (int e = static_cast<int>(std::floor(axis.lo)); e <= axis.hi; e += stride)
    for (const double m : {1.0, 2.0, 5.0})
      if (const double v = m * std::pow(10.0, e);
          (m == 1.0 || span < 2.5) && std::log10(v) >= axis.lo && std::log10(v) <= axis.hi)
        values.push_back(v);
  return values;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, escaped(text));
}

std::string line_between(double x1, double y1, double x2, double y2, const std::string& stroke) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2,
      y2, stroke);
}

std::string frame(const LogLogPlot& plot, const Axis& x, const Axis& y) {
  std::string out;
  for (const double v : ticks(x)) {
    out += line_between(x.at(v), top, x.at(v), bottom, "#dddddd");
    out += text_at(x.at(v), bottom + 18, "middle", fmt::format("{:.4g}", v));
  }
  for (const double v : ticks(y)) {
    out += line_between(left, y.at(v), right, y.at(v), "#dddddd");
    out += text_at(left - 8, y.at(v) + 4, "end", fmt::format("{:.0e}", v));
  }
  out += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#000000\"/>\n",
      left, top, right - left, bottom - top);
  const double middle = 0.5 * (top + bottom);
  out += text_at(0.5 * (left + right), top - 20, "middle", plot.title, " font-size=\"16\"");
  out += text_at(0.5 * (left + right), bottom + 42, "middle", plot.x_label);
  out += text_at(20, middle, "middle", plot.y_label,
                 fmt::format(" transform=\"rotate(-90 20 {:.1f})\"", middle));
  return out;
}

std::string line_svg(const PlotLine& line, const Axis& x, const Axis& y, const char* colour) {
  std::string points, marks;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (!is_drawn(line, i)) continue;
    const double px = x.at(line.x[i]), py = y.at(line.y[i]);
    fmt::format_to(std::back_inserter(points), "{:.2f},{:.2f} ", px, py);
    if (line.style == LineStyle::markers)
      fmt::format_to(std::back_inserter(marks),
                     "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.5\" fill=\"{}\"/>\n", px, py,
                     colour);
  }
  const char* dash = line.style == LineStyle::dashed ? " stroke-dasharray=\"7 5\"" : "";
  return fmt::format(
             "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}/>\n",
             points, colour, dash) +
         marks;
}

std::string legend_entry(const PlotLine& line, const char* colour, double y) {
  const char* dash = line.style == LineStyle::dashed ? " stroke-dasharray=\"7 5\"" : "";
  return fmt::format(
             "<line x1=\"{0}\" y1=\"{1:.1f}\" x2=\"{2}\" y2=\"{1:.1f}\" stroke=\"{3}\" "
             "stroke-width=\"2\"{4}/>\n",
             right + 16, y - 4, right + 44, colour, dash) +
         text_at(right + 52, y, "start", line.label);
}

}  // namespace

std::string to_svg(const LogLogPlot& plot) {
  const Axis x = axis_around(plot, &PlotLine::x, left, right);
  const Axis y = axis_around(plot, &PlotLine::y, bottom, top);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"#ffffff\"/>\n",
      width, height);
  out += frame(plot, x, y);
  if (!plot.legend_title.empty())
    out += text_at(right + 16, top + 6, "start", plot.legend_title, " font-weight=\"bold\"");
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const bool dashed = plot.lines[i].style == LineStyle::dashed;
    const char* colour = dashed ? "#555555" : colours[i % colours.size()];
    out += line_svg(plot.lines[i], x, y, colour);
    out += legend_entry(plot.lines[i], colour, top + 32 + 22 * static_cast<double>(i));
  }
  return out + "</svg>\n";
}

}  // namespace tdbd::simulation
