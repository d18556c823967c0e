#include "simulation/study/convergence_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace tdbd::simulation::convergence_output_test {

using Json = nlohmann::json;

/// Five levels of edges and steps: x is off 7 by 3 h^2, the pair y by h^2 and 2 h^2.
Convergence quadratic() {
  Convergence c;
  c.plan.case_file = "hole.toml";
  c.plan.keys = {"rock.edge_length", "time.step"};
  c.title = "a hole";
  c.case_hash = "abc";
  for (int i = 0; i < 5; ++i) {
    const double h = std::ldexp(0.1, -i), hh = h * h;
    ConvergenceLevel& level = c.levels.emplace_back();
    level.sizes = {h, 0.5 * h};
    level.steps = 10L << i;
    level.end.variables = {{"x", "m", {7.0 + 3.0 * hh}, 1.0, 7.0, false},
                           {"y", "N", {1.0 + hh, 2.0 + 2.0 * hh}, 1.0, 3.0, false}};
  }
  c.variables = observe(c.levels, {{}, 2.0});
  return c;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(ConvergenceOutput, as_json_has_sizes_states_and_what_every_variable_shows) {
  const Convergence c = quadratic();
  const Json j = Json::parse(to_json(c));
  EXPECT_EQ(j["command"], "converge");
  EXPECT_EQ(j["title"], "a hole");
  EXPECT_EQ(j["case_hash"], "abc");
  EXPECT_EQ(j["over"], "rock.edge_length and time.step");
  EXPECT_EQ(j["against"], "next level");
  EXPECT_TRUE(j["nominal_order"].is_null());
  ASSERT_EQ(j["levels"].size(), 5U);
  EXPECT_EQ(j["levels"][1]["size"], 0.05);
  EXPECT_EQ(j["levels"][1]["sizes"], (std::vector{0.05, 0.025}));
  EXPECT_EQ(j["levels"][1]["steps"], 20);
  EXPECT_EQ(j["levels"][1]["state"]["y"], c.levels[1].end.variables[1].values);
  const Json& x = j["variables"]["x"];
  EXPECT_EQ(x["verdict"], "order");
  EXPECT_NEAR(x["order"].get<double>(), 2.0, 1e-12);
  EXPECT_EQ(x["differences"].size(), 4U);
  EXPECT_EQ(x["extrapolated"], c.variables[0].extrapolated);
  EXPECT_EQ(x["uncertainty"]["basis"], "observed order");
  EXPECT_EQ(x["uncertainty"]["value"], c.variables[0].uncertainty->value);
}

TEST(ConvergenceOutput, as_json_has_null_for_what_is_not_known) {
  Convergence c = quadratic();
  c.nominal_order = 2.0;
  c.variables[0].order.verdict = OrderVerdict::not_settled;
  c.variables[0].order.local_orders = {NAN, 2.0};
  c.variables[0].uncertainty.reset();
  c.variables[0].extrapolated.clear();
  const Json j = Json::parse(to_json(c)), x = j["variables"]["x"];
  EXPECT_EQ(j["nominal_order"], 2.0);
  EXPECT_EQ(x["verdict"], "not settled");
  EXPECT_TRUE(x["order"].is_null());
  EXPECT_TRUE(x["local_orders"][0].is_null());
  EXPECT_EQ(x["local_orders"][1], 2.0);
  EXPECT_TRUE(x["uncertainty"].is_null());
  EXPECT_TRUE(x["extrapolated"].is_null());
}

TEST(ConvergenceOutput, as_csv_has_a_line_for_every_difference) {
  const auto lines = lines_of(to_csv(quadratic()));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "rock.edge_length,time.step,steps,x [m],y [N]");
  EXPECT_EQ(lines[2].rfind("0.05,0.025,20,", 0), 0U) << lines[2];
  EXPECT_EQ(std::ranges::count(lines[4], ','), 4);
}

/// A single value is printed with the digits that its uncertainty permits, plus one.
TEST(ConvergenceOutput, as_a_table_ends_with_the_finest_level) {
  const auto lines = lines_of(table_text(quadratic()));
  ASSERT_EQ(lines.size(), 10U);
  EXPECT_EQ(lines[0],
            "rock.edge_length and time.step of hole.toml divided by 2 over 5 levels, differences "
            "to the next level");
  EXPECT_EQ(lines[1].rfind("rock.edge_length [m]  ", 0), 0U) << lines[1];
  EXPECT_EQ(lines[2].rfind("time.step [s]  ", 0), 0U) << lines[2];
  EXPECT_EQ(lines[2].substr(34), "        0.05       0.025      0.0125     0.00625    0.003125");
  EXPECT_EQ(lines[3].substr(34), "          10          20          40          80         160");
  EXPECT_EQ(lines[4].rfind("x [m]  ", 0), 0U) << lines[4];
  EXPECT_EQ(lines[6], "observed orders; the finest level with its numerical uncertainty");
  EXPECT_EQ(lines[7],
            "  x                              2.000 (4 of 4 differences); 7.000117 +- 0.00015 m "
            "(observed order)");
  EXPECT_EQ(lines[8],
            "  y                              2.000 (4 of 4 differences); +- 0.00011 N (observed "
            "order)");
  EXPECT_EQ(lines[9],
            "The uncertainty assumes that errors continue to decrease as between these levels. It "
            "contains no error of the model.");
}

/// Nor where all differences are rounding.
TEST(ConvergenceOutput, has_no_uncertainty_where_there_is_none) {
  Convergence c = quadratic();
  c.variables[0].uncertainty.reset();
  c.variables[1].uncertainty->basis = UncertaintyBasis::exact;
  const auto lines = lines_of(table_text(c));
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_EQ(lines[7], "  x                              2.000 (4 of 4 differences)");
  EXPECT_EQ(lines[8], "  y                              2.000 (4 of 4 differences)");
}

TEST(ConvergenceOutput, names_the_reference) {
  Convergence c = quadratic();
  c.plan.reference = c.levels.back().end;
  c.variables = observe(c.levels, {c.plan.reference, 2.0});
  const auto lines = lines_of(table_text(c));
  EXPECT_NE(lines[0].find(", errors against the reference"), std::string::npos);
  EXPECT_EQ(lines[6], "observed orders");
  const Json j = Json::parse(to_json(c));
  EXPECT_EQ(j["against"], "reference");
  EXPECT_EQ(j["variables"]["x"]["errors"].size(), 5U);
  EXPECT_EQ(lines_of(to_csv(c)).size(), 6U);
}

}  // namespace tdbd::simulation::convergence_output_test
