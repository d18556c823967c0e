#include "bit/cone/cone_measures.hpp"

#include <gtest/gtest.h>

#include "verification/battery/shapes.hpp"

namespace tdbd::bit::cone_measures_test {

/// A block of 2 x 3 x 5 cm of steel, 4 cm beside the axis of a cone that stands anywhere.
TEST(ConeMass, of_a_block_beside_the_axis_is_that_of_steiners_theorem) {
  constexpr double a = 0.02, b = 0.03, c = 0.05, off = 0.04, density = 7800.0;
  constexpr double rounding = 2.5e-15;  // relative
  Bit bit;
  bit.cones.resize(2);
  bit.cones[1].X_BK = {.R = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix(),
                       .p = Vec3(0.1, -0.2, 0.05)};
  Part block;
  block.cone = 1;
  block.density = density;
  block.mesh_P = battery::box({off - 0.5 * a, -0.5 * b, 0.0}, {off + 0.5 * a, 0.5 * b, c});
  block.X_BP = bit.cones[1].X_BK;
  bit.parts.push_back(block);
  Part other = block;
  other.cone = 0;
  bit.parts.push_back(other);
  const ConeMass m = cone_mass(bit, 1);
  const double mass = density * a * b * c;
  const double axial = mass * ((a * a + b * b) / 12.0 + off * off);
  EXPECT_NEAR(m.body_K.mass, mass, rounding * mass);
  EXPECT_NEAR(m.centre_off_axis, off, rounding * off);
  EXPECT_NEAR(m.axial_inertia, axial, rounding * axial);
  EXPECT_NEAR(m.asymmetry, mass * (b * b - a * a) / 12.0 / axial, rounding);
}

}  // namespace tdbd::bit::cone_measures_test
