#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/rotate_folder.hpp"
#include "app/small_case.hpp"

namespace tdbd::app::converge_test {

using Json = nlohmann::json;

/// Required bound on the difference between observed order and the order of the method.
constexpr double of_order_2 = 0.05, of_order_4 = 0.1;

Json orders_of(const RotateFolder& c, std::vector<std::string> more) {
  more.insert(more.begin(), {"--over", "time.step", "--quiet", "--force"});
  const auto o = c.converge(more);
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(o.out + o.err, "");
  return Json::parse(read(c.path("orders/convergence.json")));
}

void expect_order(const Json& study, const std::string& variable, double order, double tolerance) {
  const Json& v = study["variables"][variable];
  ASSERT_EQ(v["verdict"], "order") << variable << ": " << v["in_words"];
  EXPECT_NEAR(v["order"].get<double>(), order, tolerance) << variable;
  EXPECT_GE(v["used"], 3) << variable;
}

TEST(Converge, the_case_with_all_loads_has_order_2_in_every_variable) {
  const RotateFolder c;
  for (const char* drift : {"split", "three-axis", "lie-midpoint", "lie-mean"}) {
    const Json study =
        orders_of(c, {"--levels", "6", "--set", std::string("integrator.drift=") + drift});
    EXPECT_EQ(study["variables"].size(), 7u);
    EXPECT_EQ(study["levels"].size(), 6u);
    for (const char* v : {"attitude", "body_momentum", "space_momentum", "angular_velocity",
                          "cone_angles", "cone_momenta", "energy"})
      expect_order(study, v, 2.0, of_order_2);
  }
}

TEST(Converge, the_composition_has_order_4) {
  RotateFolder c;
  c.write("case.toml", free_body_text);
  const Json study =
      orders_of(c, {"--levels", "6", "--set", "integrator.order=4", "--set", "time.step=0.4"});
  for (const char* v : {"attitude", "body_momentum", "angular_velocity", "cone_angles"})
    expect_order(study, v, 4.0, of_order_4);
  EXPECT_EQ(study["nominal_order"], 4.0);
}

TEST(Converge, what_is_conserved_is_exact_and_has_no_order) {
  RotateFolder c;
  c.write("case.toml", free_body_text);
  const Json study = orders_of(c, {"--levels", "5"});
  for (const char* v : {"space_momentum", "cone_momenta"}) {
    EXPECT_EQ(study["variables"][v]["verdict"], "exact");
    EXPECT_TRUE(study["variables"][v]["order"].is_null());
    EXPECT_EQ(study["variables"][v]["differences"], Json::array({0.0, 0.0, 0.0, 0.0}));
  }
}

TEST(Converge, fewer_than_three_differences_give_no_order_but_words) {
  const RotateFolder c;
  const Json v = orders_of(c, {"--levels", "3"})["variables"]["attitude"];
  EXPECT_EQ(v["verdict"], "too few");
  EXPECT_TRUE(v["order"].is_null());
  EXPECT_EQ(v["in_words"], "no order: 2 of 2 differences above rounding, at least 3 are needed");
}

TEST(Converge, against_a_reference_every_level_has_an_error) {
  const RotateFolder c;
  ASSERT_EQ(c.rotate({"--set", "integrator.order=6", "--quiet"}, "fine").exit_code, 0);
  for (const char* reference : {"fine", "fine/summary.json"}) {
    const Json study = orders_of(c, {"--levels", "4", "--reference", c.path(reference)});
    EXPECT_EQ(study["against"], "reference");
    EXPECT_EQ(study["variables"]["attitude"]["errors"].size(), 4u);
    expect_order(study, "attitude", 2.0, of_order_2);
    expect_order(study, "cone_momenta", 2.0, of_order_2);
  }
}

TEST(Converge, prints_a_table_and_writes_two_files) {
  const RotateFolder c;
  const auto o = c.converge({"--over", "time.step", "--levels", "4"});
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("100 %  step 200 of 200  0.0 s left  level 1 of 4\n"), std::string::npos)
      << o.err;
  EXPECT_NE(o.err.find("100 %  step 1600 of 1600  0.0 s left  level 4 of 4\n"), std::string::npos)
      << o.err;
  EXPECT_NE(o.out.find("\ntime.step [s]                             0.01       0.005      0.0025"),
            std::string::npos)
      << o.out;
  EXPECT_NE(o.out.find("\n  space_momentum                 2.000 (3 of 3 differences); +- "),
            std::string::npos)
      << o.out;
  EXPECT_EQ(files_below(c.path("orders")),
            (std::vector<std::string>{"convergence.csv", "convergence.json"}));
  EXPECT_EQ(lines_of(c.path("orders/convergence.csv")), 4);
  EXPECT_EQ(read(c.path("orders/convergence.csv")).rfind("time.step,steps,attitude [rad],", 0), 0u);
}

TEST(Converge, the_same_study_is_bitwise_identical) {
  const RotateFolder c;
  const std::vector<std::string> study{"--over", "time.step", "--levels", "4", "--quiet"};
  ASSERT_EQ(c.converge(study, "first").exit_code, 0);
  ASSERT_EQ(c.converge(study, "second").exit_code, 0);
  expect_same_results(c.path("first"), c.path("second"), 2);
}

TEST(Converge, steps_that_do_not_divide_the_duration_count_as_they_are) {
  RotateFolder c;
  c.write("case.toml", free_body_text);
  const Json study = orders_of(c, {"--levels", "5", "--factor", "1.7"});
  EXPECT_EQ(study["levels"][1]["steps"], 170);
  EXPECT_EQ(study["levels"][1]["size"], 2.0 / 170.0);
  EXPECT_EQ(study["levels"][2]["steps"], 289);
  expect_order(study, "attitude", 2.0, of_order_2);
}

TEST(Converge, any_quantity_of_the_case_can_be_divided) {
  RotateFolder c;
  c.write("case.toml", free_body_text);
  const auto o = c.converge({"--over", "cones[1].axial_inertia", "--levels", "4"});
  EXPECT_EQ(o.exit_code, 0) << o.err;
  const Json study = Json::parse(read(c.path("orders/convergence.json")));
  EXPECT_EQ(study["levels"][3]["size"], 0.2 / 8.0);
  EXPECT_TRUE(study["nominal_order"].is_null());
}

TEST(Converge, drills_a_run_case_over_its_step) {
  const SmallCase c;
  const auto o = battery::run_tdbd({"converge", c.path("case.toml"), "--over", "time.step",
                                    "--levels", "3", "-o", c.path("orders"), "--quiet"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const Json study = Json::parse(read(c.path("orders/convergence.json")));
  for (const char* v : {"removed_volume", "removed_volume_by_part", "removed_volume_by_revolution"})
    EXPECT_EQ(study["variables"][v]["differences"].size(), 2u) << v;
  EXPECT_EQ(study["levels"][2]["steps"], 80);
  EXPECT_EQ(study["levels"][0]["state"]["removed_volume_by_part"].size(), 13u);
  EXPECT_EQ(study["title"], "small");
}

/// Drilling: both quantities at once; surfaces are compared, and every variable has an uncertainty.
TEST(Converge, drills_over_edges_and_steps_at_once) {
  const SmallCase c;
  const auto o = battery::run_tdbd({"converge", c.path("case.toml"), "--over", "rock.edge_length",
                                    "--over", "time.step", "--levels", "3", "--factor", "1.4", "-o",
                                    c.path("orders"), "--quiet"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const Json study = Json::parse(read(c.path("orders/convergence.json")));
  EXPECT_EQ(study["over"], "rock.edge_length and time.step");
  EXPECT_TRUE(study["nominal_order"].is_null());
  EXPECT_EQ(study["levels"][1]["steps"], 28);  // the step nearest to 1/20/1.4 of the duration
  EXPECT_EQ(study["levels"][1]["sizes"].size(), 2u);
  for (const char* name : {"surface_distance", "volume_between"}) {
    const Json& v = study["variables"][name];
    EXPECT_EQ(v["differences"].size(), 2u);
    EXPECT_GT(v["differences"][0].get<double>(), 0.0) << name;
    EXPECT_GT(v["uncertainty"]["value"].get<double>(), 0.0) << name;
  }
  EXPECT_EQ(read(c.path("orders/convergence.csv")).rfind("rock.edge_length,time.step,steps,", 0),
            0u);
}

TEST(Converge, a_single_value_is_extrapolated) {
  const RotateFolder c;
  const Json study = orders_of(c, {"--levels", "5"});
  const Json& energy = study["variables"]["energy"];
  const double fine = study["levels"][4]["state"]["energy"][0],
               before = study["levels"][3]["state"]["energy"][0];
  const double order = energy["uncertainty"]["order"];
  EXPECT_DOUBLE_EQ(energy["extrapolated"][0].get<double>(),
                   fine + (fine - before) / (std::pow(2.0, order) - 1.0));
  EXPECT_TRUE(study["variables"]["attitude"]["extrapolated"].is_null());
}

TEST(Converge, an_interrupted_study_keeps_the_levels_that_were_done) {
  const RotateFolder c;
  const auto o = battery::run_tdbd({"converge", c.path("case.toml"), "--over", "time.step",
                                    "--levels", "40", "-o", c.path("orders"), "--quiet"},
                                   {.signal_after_seconds = 1.5});
  EXPECT_EQ(o.exit_code, 130) << o.err;
  const Json study = Json::parse(read(c.path("orders/convergence.json")));
  EXPECT_EQ(study["status"], "interrupted");
  EXPECT_GE(study["levels"].size(), 4u);
  EXPECT_LT(study["levels"].size(), 40u);
  expect_order(study, "attitude", 2.0, of_order_2);
}

void expect_study_refused(const RotateFolder& c, std::vector<std::string> more,
                          const std::string& message) {
  expect_refusal(c.converge(more), message);
  EXPECT_FALSE(std::filesystem::exists(c.path("orders")));
}

/// The same numbers on any number of threads, which must be one at least.
TEST(Converge, takes_threads) {
  const RotateFolder c;
  const std::vector<std::string> study{"--over", "time.step", "--levels", "3", "--threads"};
  const auto with = [&](const std::string& threads) {
    std::vector<std::string> more = study;
    more.push_back(threads);
    return more;
  };
  EXPECT_EQ(c.converge(with("2"), "two").exit_code, 0);
  EXPECT_EQ(c.converge(with("1"), "one").exit_code, 0);
  EXPECT_EQ(read(c.path("two/convergence.csv")), read(c.path("one/convergence.csv")));
  EXPECT_EQ(c.converge(with("0"), "none").exit_code, 2);
}

TEST(Converge, a_wrong_study_is_rejected) {
  const RotateFolder c;
  const std::vector<std::string> levels{"--levels", "4"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), levels.begin(), levels.end());
    return more;
  };
  expect_study_refused(c, with({"--over", "time.stp"}),
                       "--over: found time.stp, expected a quantity of the case: time.step");
  expect_study_refused(c, with({"--over", "body.angular_velocity"}),
                       "--over: found body.angular_velocity, expected a quantity of the case: "
                       "time.step, for example");
  expect_study_refused(c, with({"--over", "cones[1].angle"}),
                       "--over: cones[1].angle: found 0, expected a quantity > 0");
  expect_study_refused(c, with({"--over", "time.step", "--over", "time.step"}),
                       "--over: found time.step twice, expected every quantity once");
  expect_study_refused(c, with({"--over", "time.step", "--factor", "1"}),
                       "--factor: found 1, expected a number > 1");
  expect_study_refused(c, with({"--over", "time.step", "--reference", "/absent"}),
                       "/absent: found no such file, expected a summary.json or the folder of a "
                       "result");
}

TEST(Converge, levels_that_end_at_different_times_are_rejected) {
  const RotateFolder c;
  const auto o = c.converge({"--over", "time.duration", "--levels", "4"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find("--over: level 2, time.duration = 1: found an end at t = 1 s, expected 2 s, "
                       "as of the first level"),
            std::string::npos)
      << o.err;
  EXPECT_FALSE(std::filesystem::exists(c.path("orders")));
}

TEST(Converge, a_last_level_that_is_no_right_case_is_rejected_before_the_first_runs) {
  const RotateFolder c;
  expect_study_refused(
      c, {"--over", "time.step", "--levels", "60"},
      "--over: level 60, time.step = 1.734723475976807e-20: --set: time.step: "
      "found 1.734723475976807e-20 s, which makes 1.15e+20 steps, expected at most "
      "1000000000000000 steps");
}

TEST(Converge, neighbours_with_the_same_steps_are_rejected) {
  const RotateFolder c;
  expect_study_refused(c, {"--over", "time.step", "--levels", "3", "--factor", "1.0001", "--quiet"},
                       "--factor: level 2: found 200 steps, as at level 1, expected more: take a "
                       "larger factor");
}

TEST(Converge, a_reference_of_another_kind_is_rejected) {
  const RotateFolder c;
  c.write("summary.json", "{\"command\": \"bit\", \"duration_s\": 1}");
  const auto other =
      c.converge({"--over", "time.step", "--levels", "4", "--reference", c.path("summary.json")});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("summary.json: found the command \"bit\""), std::string::npos)
      << other.err;
  ASSERT_EQ(c.rotate({"--set", "time.duration=1"}).exit_code, 0);
  const auto shorter =
      c.converge({"--over", "time.step", "--levels", "4", "--reference", c.path("out")});
  EXPECT_EQ(shorter.exit_code, 2);
  EXPECT_NE(shorter.err.find("--reference: found an end at t = 1 s, expected 2 s"),
            std::string::npos)
      << shorter.err;
}

TEST(Converge, wrong_numbers_of_levels_are_rejected_by_the_command_line) {
  const RotateFolder c;
  for (const char* levels : {"1", "0", "-3", "1000", "many"})
    EXPECT_EQ(c.converge({"--over", "time.step", "--levels", levels}).exit_code, 2) << levels;
}

}  // namespace tdbd::app::converge_test
