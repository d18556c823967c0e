#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/battery/evidence.hpp"
#include "verification/battery/rotation_checks.hpp"

namespace tdbd::battery::conservation_test {

constexpr double step = 0.01;  ///< s
constexpr long many = 100'000, most = 10'000'000;
constexpr double unit_quaternion = 1e-15;  ///< | |q|^2 - 1 |: four ulps
constexpr double reversed = 1e-12;         ///< after 100 steps and back, order one to ten

/// Claims of the thesis are measured on its drift; ours on the others.
std::string momentum_claim(const RotationScheme& scheme) {
  return scheme.name == "lie-midpoint" ? "chapter5/momentum" : "ours/momentum";
}

bool is_free(const GoldenCase& c) {
  return c.loads.gravity_moment == 0.0 && c.loads.body_torque_B.isZero(0.0);
}
bool cones_untorqued(const GoldenCase& c) {
  for (const dynamics::ConeLoad& l : c.loads.cones)
    if (l.internal != 0.0) return false;
  return true;
}
/// Gravity turns about horizontal axes alone.
bool keeps_vertical_momentum(const GoldenCase& c) { return c.loads.body_torque_B.isZero(0.0); }

void expect_conserved(const RotationScheme& scheme, const GoldenCase& c, long steps) {
  // The Lie drifts want |W| h <= 1; the fast top turns at 50 rad/s.
  const ConservationDefects d = conservation_defects(scheme, c, step, steps);
  const std::string where = scheme.name + " on " + c.name;
  if (is_free(c)) {
    EXPECT_EQ(d.space_momentum, 0.0) << where;
  }
  if (keeps_vertical_momentum(c)) {
    EXPECT_EQ(d.vertical_momentum, 0.0) << where;
  }
  if (cones_untorqued(c)) {
    EXPECT_EQ(d.cone_momenta, 0.0) << where;
  }
  EXPECT_LE(d.unit_quaternion, unit_quaternion) << where;
}

TEST(Conservation, momenta_that_no_torque_changes_stay_to_the_bit) {
  std::vector<RotationScheme> schemes = second_order_schemes();
  for (const RotationScheme& s : composed_schemes(6)) schemes.push_back(s);
  for (const RotationScheme& scheme : schemes)
    for (const std::string& name : golden_names())
      expect_conserved(scheme, read_golden_case(name), many / 10);
}

TEST(Conservation, momentum_of_a_free_gyrostat_stays_to_the_bit_over_1e7_steps) {
  const GoldenCase c = read_golden_case("gyro_free_sym");
  for (const RotationScheme& scheme : composed_schemes(2)) {
    const ConservationDefects d = conservation_defects(scheme, c, step, most);
    EXPECT_EQ(d.space_momentum, 0.0) << scheme.name;
    EXPECT_EQ(d.cone_momenta, 0.0) << scheme.name;
    EXPECT_LE(d.unit_quaternion, unit_quaternion) << scheme.name;
    record({momentum_claim(scheme),
            scheme.name + ": change of the spatial momentum over 1e7 steps, gyro_free_sym",
            d.space_momentum, "N m s", "0, bitwise",
            d.space_momentum == 0.0 ? Verdict::holds : Verdict::refuted});
    record({momentum_claim(scheme),
            scheme.name + ": largest | |q|^2 - 1 | over 1e7 steps, gyro_free_sym",
            d.unit_quaternion, "1", fmt::format("<= {}", unit_quaternion),
            d.unit_quaternion <= unit_quaternion ? Verdict::holds : Verdict::refuted});
  }
}

TEST(Conservation, vertical_momentum_of_the_top_stays_to_the_bit) {
  for (const RotationScheme& scheme : composed_schemes(2)) {
    const double change =
        conservation_defects(scheme, read_golden_case("slow_top"), step, many).vertical_momentum;
    EXPECT_EQ(change, 0.0) << scheme.name;
    record({momentum_claim(scheme),
            scheme.name + ": change of the vertical momentum over 1e5 steps, slow_top", change,
            "N m s", "0, bitwise", change == 0.0 ? Verdict::holds : Verdict::refuted});
  }
}

TEST(Reversibility, a_step_with_minus_h_undoes_the_step) {
  for (const RotationScheme& scheme : second_order_schemes()) {
    double worst = 0.0;
    for (const std::string& name : golden_names()) {
      const GoldenCase c = read_golden_case(name);
      const double defect = reversibility_defect(scheme, c, step, 100);
      EXPECT_LE(defect, reversed) << scheme.name << " on " << name;
      worst = std::max(worst, defect);
    }
    record({"ours/reversible",
            scheme.name + ": largest difference after 100 steps and back, nine golden cases", worst,
            "1", fmt::format("<= {}", reversed),
            worst <= reversed ? Verdict::holds : Verdict::refuted});
  }
}

}  // namespace tdbd::battery::conservation_test
