#include "simulation/study/convergence.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "verification/simulation/mesh_bit.hpp"

namespace tdbd::simulation::convergence_test {

constexpr const char* body_text = R"(title = "a free body"
[body]
inertia = [[2, 0, 0], [0, 2.6, 0], [0, 0, 3]]
angular_velocity = [0.7, -0.5, 2]
[[cones]]
axis = [0.8, 0, 0.6]
axial_inertia = 0.1
spin = -7
[time]
step = 0.1
duration = 1
)";

/// Over the step of a free body with a cone, from 10 steps of 0.1 s.
ConvergencePlan of_body(int levels, std::vector<std::string> keys = {"time.step"}) {
  ConvergencePlan plan;
  plan.case_file = write_file(test_folder() / "case.toml", body_text);
  plan.keys = std::move(keys);
  plan.levels = levels;
  return plan;
}

/// Over the edges of a coarse hole, eight steps.
ConvergencePlan of_hole(int levels, std::vector<std::string> keys) {
  ConvergencePlan plan;
  plan.case_file = TDBD_SOURCE_DIR "/cases/bit-b-steady.toml";
  plan.overrides = {"rock.edge_length='9 mm'", "time.step='2 ms'", "time.revolutions=0.032"};
  plan.keys = std::move(keys);
  plan.levels = levels;
  plan.factor = 1.25;
  return plan;
}

/// What is said of the progress: of each level the last steps done, and steps in all.
using Said = std::map<int, std::pair<long, long>>;

ConvergenceOptions listened(Said& said) {
  ConvergenceOptions o;
  o.progress = [&](int level, long done, long total) { said[level] = {done, total}; };
  return o;
}

TEST(Convergence, halves_the_step_and_finds_the_order_of_every_variable) {
  const Convergence c = converge(of_body(5), {});
  EXPECT_EQ(c.status, RunStatus::completed);
  EXPECT_EQ(c.title, "a free body");
  EXPECT_EQ(c.nominal_order, 2.0);
  ASSERT_EQ(c.levels.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(c.levels[i].steps, 10L << i);
    ASSERT_EQ(c.levels[i].sizes.size(), 1U);
    EXPECT_DOUBLE_EQ(c.levels[i].sizes[0], std::ldexp(0.1, -static_cast<int>(i)));
    EXPECT_FALSE(c.levels[i].moved);
  }
  ASSERT_EQ(c.variables.size(), 7U);
  EXPECT_EQ(c.variables[0].name, "attitude");
  EXPECT_NEAR(c.variables[0].order.order, 2.0, 6.5e-4);
}

TEST(Convergence, reports_the_progress_of_each_level) {
  Said said;
  converge(of_body(3), listened(said));
  EXPECT_EQ(said, (Said{{1, {10, 10}}, {2, {20, 20}}, {3, {40, 40}}}));
}

/// The step is the nearest one that divides the duration; the order in two quantities is not known.
TEST(Convergence, divides_several_quantities_at_once) {
  ConvergencePlan plan = of_body(3, {"cones[0].axial_inertia", "time.step"});
  plan.factor = 1.4;
  const Convergence c = converge(plan, {});
  EXPECT_EQ(c.nominal_order, 0.0);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_DOUBLE_EQ(c.levels[i].sizes[0], 0.1 / std::pow(1.4, static_cast<double>(i)));
  const long steps[] = {10, 14, 20};  // 10, 14 and 19.6
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(c.levels[i].steps, steps[i]);
    EXPECT_DOUBLE_EQ(c.levels[i].sizes[1], 1.0 / static_cast<double>(steps[i]));
  }
  EXPECT_EQ(keys_in_words(plan), "cones[0].axial_inertia and time.step");
}

TEST(Convergence, of_no_step_has_no_order_of_the_method) {
  EXPECT_EQ(check(of_body(3, {"cones[0].axial_inertia"})).nominal_order, 0.0);
  ConvergencePlan fourth = of_body(3);
  fourth.overrides = {"integrator.order=4"};
  EXPECT_EQ(check(fourth).nominal_order, 4.0);
}

TEST(Convergence, compares_holes_and_uses_threads) {
  const ConvergencePlan plan = of_hole(3, {"rock.edge_length"});
  Said said;
  const Convergence c = converge(plan, listened(said));
  EXPECT_EQ(said, (Said{{1, {8, 8}}, {2, {8, 8}}, {3, {8, 8}}}));
  EXPECT_EQ(c.nominal_order, 0.0);
  ASSERT_EQ(c.levels.size(), 3U);
  EXPECT_FALSE(c.levels[0].moved);
  EXPECT_GT(c.levels[1].moved.value().largest, 0.0);
  EXPECT_GT(c.levels[2].moved.value().volume, 0.0);
  EXPECT_NEAR(c.levels[2].sizes[0], 0.009 / 1.25 / 1.25, 1e-15);
  const auto& v = c.variables;
  ASSERT_GE(v.size(), 2U);
  EXPECT_EQ(v[v.size() - 2].name, "surface_distance");
  EXPECT_EQ(v.back().name, "volume_between");
  EXPECT_EQ(v.back().differences,
            (std::vector{c.levels[1].moved->volume, c.levels[2].moved->volume}));
  ASSERT_TRUE(v.back().uncertainty);
  EXPECT_GT(v.back().uncertainty->value, 0.0);
  EXPECT_EQ(check(of_hole(3, {"time.step"})).nominal_order, 2.0);
}

/// After the levels that are done.
TEST(Convergence, ends_where_it_is_interrupted) {
  for (const ConvergencePlan& plan : {of_body(4), of_hole(3, {"rock.edge_length"})}) {
    std::atomic<bool> stop = false;
    ConvergenceOptions o;
    o.interrupted = &stop;
    o.progress = [&](int level, long done, long) { stop = level == 2 && done == 3; };
    const Convergence c = converge(plan, o);
    EXPECT_EQ(c.status, RunStatus::interrupted);
    EXPECT_EQ(c.levels.size(), 1U);
  }
}

TEST(Convergence, against_a_reference_has_errors) {
  ConvergencePlan plan = of_body(3);
  EXPECT_EQ(error_name(plan), "differences");
  plan.reference = converge(of_body(6), {}).levels.back().end;
  EXPECT_EQ(error_name(plan), "errors");
  const Convergence c = converge(plan, {});
  ASSERT_EQ(c.variables[0].differences.size(), 3U);
  EXPECT_GT(c.variables[0].differences[2], 0.0);
  EXPECT_LT(c.variables[0].differences[2], 0.3 * c.variables[0].differences[1]);
  EXPECT_FALSE(c.variables[0].uncertainty);
}

/// What is refused, in its own words; empty: nothing.
std::string refusal(const ConvergencePlan& plan) {
  try {
    converge(plan, {});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Convergence, names_a_wrong_quantity) {
  EXPECT_EQ(refusal(of_body(3, {})), "--over: found none, expected a quantity of the case");
  EXPECT_EQ(refusal(of_body(3, {"time.step", "time.step"})),
            "--over: found time.step twice, expected every quantity once");
  EXPECT_EQ(refusal(of_body(3, {"time.stp"})),
            "--over: found time.stp, expected a quantity of the case: time.step");
  EXPECT_EQ(refusal(of_body(3, {"cones[0].angle"})),
            "--over: cones[0].angle: found 0, expected a quantity > 0");
  EXPECT_EQ(refusal(of_body(3, {"time.duration"})),
            "--over: level 2, time.duration = 0.5: found an end at t = 0.5 s, expected 1 s, as of "
            "the first level");
}

TEST(Convergence, names_a_wrong_number_of_levels_or_factor) {
  for (const int levels : {-1, 0, 1, 61})
    EXPECT_EQ(refusal(of_body(levels)).rfind("--levels: found " + std::to_string(levels), 0), 0U);
  for (const double factor : {1.0, 0.5, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    ConvergencePlan plan = of_body(3);
    plan.factor = factor;
    EXPECT_EQ(refusal(plan).rfind("--factor: found ", 0), 0U) << factor;
  }
  ConvergencePlan plan = of_body(3);
  plan.factor = 1.0001;
  EXPECT_EQ(
      refusal(plan),
      "--factor: level 2: found 10 steps, as at level 1, expected more: take a larger factor");
}

TEST(Convergence, names_a_reference_that_is_of_another_case) {
  const EndState end = converge(of_body(2), {}).levels.back().end;
  const auto with = [&](auto&& change) {
    ConvergencePlan plan = of_body(2);
    plan.reference = end;
    change(*plan.reference);
    return refusal(plan);
  };
  EXPECT_EQ(with([](EndState&) {}), "");
  EXPECT_EQ(with([](EndState& e) { e.command = "run"; }),
            "--reference: found the state of a run case, expected that of a rotate case");
  EXPECT_EQ(with([](EndState& e) { e.duration = 2.0; }),
            "--reference: found an end at t = 2 s, expected 1 s, as of the first level (choose "
            "steps that divide the duration)");
  EXPECT_EQ(with([](EndState& e) { e.variables[1].values.push_back(0.0); }),
            "--reference: found body_momentum with 4 values, expected as many as in the case");
}

/// An end is the same to a part in a billion, however long the run is.
TEST(Convergence, takes_a_reference_that_ends_at_the_same_time_but_for_rounding) {
  for (const char* duration : {"0.2", "1", "30"}) {
    ConvergencePlan plan = of_body(2);
    plan.overrides = {std::string("time.duration=") + duration};
    plan.reference = converge(plan, {}).levels.back().end;
    plan.reference->duration *= 1.0 + 5e-10;
    EXPECT_EQ(refusal(plan), "") << duration;
    plan.reference->duration *= 1.0 + 2e-9;
    EXPECT_NE(refusal(plan), "") << duration;
  }
}

}  // namespace tdbd::simulation::convergence_test
