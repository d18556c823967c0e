#include "reference/dynamics/work_precision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "battery/evidence.hpp"
#include "battery/golden.hpp"
#include "core/error.hpp"

namespace tdbd::reference::work_precision_test {

const std::map<std::string, Rival> rivals{
    {"rk8pd", Rival::rk8pd}, {"rkf45", Rival::rkf45}, {"rk4", Rival::rk4}};

std::vector<WorkPrecision> on_the_slow_top(Rival rival, const std::vector<double>& accuracies) {
  const battery::GoldenCase c = battery::read_golden_case("slow_top");
  return work_precision(c.gyrostat, c.loads, matrix_state(c.initial), 10.0, rival, accuracies);
}

std::vector<double> ladder(Rival rival) {
  if (rival == Rival::rk4) return {200, 400, 800, 1600, 3200, 6400, 12800, 25600};
  return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13};
}

TEST(WorkPrecision, the_rivals_on_the_slow_top) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& [name, rival] : rivals)
    for (const WorkPrecision& p : on_the_slow_top(rival, ladder(rival))) {
      EXPECT_GT(p.evaluations, 0);
      rows.push_back({{"method", name},
                      {"accuracy", p.accuracy},
                      {"torque_evaluations", p.evaluations},
                      {"attitude_error_rad", p.attitude_error}});
    }
  battery::record_table("work-precision-rivals", rows);
}

/// The error is the angle to the golden attitude, too.
TEST(WorkPrecision, errors_are_true_errors) {
  const battery::GoldenCase c = battery::read_golden_case("slow_top");
  for (const auto& [name, rival] : rivals)
    for (const WorkPrecision& p : on_the_slow_top(rival, ladder(rival)))
      EXPECT_NEAR(p.attitude_error, angle_between(p.end.R_WB, c.states.back().R_WB), 1e-12) << name;
}

TEST(WorkPrecision, rk4_converges_with_order_4_at_4_evaluations_a_step) {
  const auto points = on_the_slow_top(Rival::rk4, {3200, 6400});
  EXPECT_EQ(points[0].evaluations, 4 * 3200);
  EXPECT_NEAR(std::log2(points[0].attitude_error / points[1].attitude_error), 4.0, 0.1);
}

TEST(WorkPrecision, angle_between_attitudes) {
  const auto turned = [](double angle) {
    return Mat3(Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()));
  };
  EXPECT_NEAR(angle_between(turned(0.3), turned(0.3 + 1e-9)), 1e-9, 1e-15);
  EXPECT_NEAR(angle_between(turned(0.3), turned(2.8)), 2.5, 1e-14);
}

TEST(WorkPrecision, refuses_what_it_cannot_run) {
  EXPECT_THROW(on_the_slow_top(Rival::rk4, {0.5}), InputError);
  EXPECT_THROW(on_the_slow_top(Rival::rk4, {-2.0}), InputError);
  EXPECT_THROW(on_the_slow_top(Rival::rk4, {1e9}), InputError);
  EXPECT_THROW(on_the_slow_top(Rival::rkf45, {0.0}), InputError);
  EXPECT_THROW(on_the_slow_top(Rival::rk8pd, {std::nan("")}), InputError);
  dynamics::Loads sampled;
  sampled.samples.resize(1);
  EXPECT_THROW(work_precision({}, sampled, {}, 1.0, Rival::rk4, {10.0}), InputError);
}

}  // namespace tdbd::reference::work_precision_test
