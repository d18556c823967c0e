#include "string/side_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/types.hpp"
#include "verification/string/wells.hpp"

namespace tdbd::string::side_force_test {

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// Tension T and weight w in a circular arc: per length |w sin(inc) - T/R| where it builds.
double force_on_arc(int elements) {
  const Survey survey = build_and_hold();
  const auto sections = plain_build_and_hold();
  const Contact c = make_contact(sections, survey, {}, elements);
  std::vector<double> force(at(elements) + 1);
  side_forces(c, std::vector<double>(at(elements), 2e5), force);
  return sum(force);
}

TEST(SideForce, of_constant_tension_over_a_well_is_the_integral_by_arc_length) {
  const double T = 2e5, R = 600.0 / (60.0 * degree), w = plain_build_and_hold()[0].weight;
  const int steps = 200000;
  double exact = 1400.0 * w * std::sin(60.0 * degree);
  for (int i = 0; i < steps; ++i)
    exact += 600.0 / steps * std::abs(w * std::sin(60.0 * degree * (i + 0.5) / steps) - T / R);
  const double coarse = force_on_arc(125) / exact - 1.0, fine = force_on_arc(250) / exact - 1.0;
  EXPECT_LE(std::abs(fine), 3e-6);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3);
}

TEST(SideForce, weights_along_the_hole_add_up_to_the_fall_of_the_well) {
  const Contact c = make_contact(plain_build_and_hold(), build_and_hold(), {}, 37);
  const double fall = position_at(build_and_hold(), 2500.0).z();
  EXPECT_NEAR(sum(c.weight) / (plain_build_and_hold()[0].weight * fall), 1.0, 2e-15);
}

TEST(SideForce, friction_changes_with_depth_inside_an_element) {
  const Contact c =
      make_contact({drill_pipe(100.0)}, vertical(), {{0.0, 0.2, 0.1}, {53.0, 0.4, 0.3}}, 10);
  EXPECT_DOUBLE_EQ(c.resting[4], 0.2);
  EXPECT_NEAR(c.resting[5], 0.2 * 0.8 + 0.4 * 0.2, 1e-15);
  EXPECT_NEAR(c.sliding[6], 0.3, 1e-15);
}

TEST(SideForce, both_ends_leave_their_friction_to_the_nodes_beside_them) {
  const Contact c = make_contact(plain_build_and_hold(), build_and_hold(), {{0.0, 0.3, 0.3}}, 50);
  EXPECT_EQ(c.resting.front(), 0.0);
  EXPECT_EQ(c.resting.back(), 0.0);
  EXPECT_EQ(c.node.front(), 1);
  EXPECT_EQ(c.node.back(), 49);
}

}  // namespace tdbd::string::side_force_test
