#include "simulation/study/log_log_plot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation {
namespace {

LogLogPlot two_decades() {
  LogLogPlot plot{"a < b & c", "step", "error", "lines", {}};
  plot.lines.push_back({"first", {0.01, 0.1, 1.0}, {1e-6, 1e-4, 1e-2}, LineStyle::markers});
  plot.lines.push_back({"nominal", {0.01, 1.0}, {1e-6, 1e-2}, LineStyle::dashed});
  return plot;
}

/// check_plot.py reads it as XML and finds the points on a straight line of the slope of the axes.
int check(const LogLogPlot& plot, const std::string& points) {
  const std::string file = tdbd::temporary_folder() + "tdbd_plot.svg";
  std::ofstream(file) << to_svg(plot);
  const std::string command = std::string("/usr/bin/python3 -B ") + TDBD_SOURCE_DIR +
                              "/verification/simulation/check_plot.py " + file + " " + points;
  return std::system(command.c_str());
}

TEST(log_log_plot, is_xml_with_every_point_inside_its_frame) {
  EXPECT_EQ(check(two_decades(), "3"), 0);
}

TEST(log_log_plot, leaves_out_what_has_no_logarithm) {
  LogLogPlot plot = two_decades();
  plot.lines[0].y[1] = 0.0;
  EXPECT_EQ(check(plot, "2"), 0);
  plot.lines[0].y = {0.0, 0.0, 0.0};
  plot.lines.pop_back();
  EXPECT_EQ(check(plot, "0"), 0);
  plot.lines.clear();
  EXPECT_EQ(check(plot, "0"), 0);
}

TEST(log_log_plot, one_point_alone_is_drawn) {
  LogLogPlot plot{"", "", "", "", {{"one", {1.0}, {1.0}, LineStyle::markers}}};
  EXPECT_EQ(check(plot, "1"), 0);
}

TEST(log_log_plot, gives_the_same_bytes_for_the_same_plot) {
  EXPECT_EQ(to_svg(two_decades()), to_svg(two_decades()));
}

}  // namespace
}  // namespace tdbd::simulation
