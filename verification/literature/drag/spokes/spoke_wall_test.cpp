#include "reference/literature/drag/spokes/spoke_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference::spoke_wall_test {
namespace {

/// A mass against the spring by velocity Verlet in steps of 10 us, as the worked number was made.
struct Impact {
  double deepest = 0.0, strongest = 0.0, contact = 0.0, speed_out = 0.0;
};

Impact impact(double mass, const WallSpring& spring, double speed) {
  constexpr double h = 1e-5;
  double p = 0.0, v = speed;
  Impact found;
  do {
    v -= h / 2.0 * spring_force(spring, p, v) / mass;
    p += h * v;
    const double force = spring_force(spring, p, v);
    found.deepest = std::max(found.deepest, p);
    found.strongest = std::max(found.strongest, force);
    v -= h / 2.0 * force / mass;
    found.contact += h;
  } while (p > 0.0);
  found.speed_out = -v;
  return found;
}

TEST(SpokeWall, throws_a_bit_back_with_less_speed) {
  constexpr double mass = 500.0, k = 1e8, e = 0.6, v = 0.1;
  const double w0 = std::sqrt(k / mass), deepest = v / w0;
  EXPECT_NEAR(deepest, 0.223607e-3, 1e-9);
  EXPECT_NEAR(k * deepest, 22360.68, 0.01);
  const double contact = std::numbers::pi / 2.0 * (1.0 + 1.0 / e) / w0;
  EXPECT_NEAR(contact, 9.36642e-3, 1e-8);
  EXPECT_NEAR(0.5 * mass * v * v * (1.0 - e * e), 1.600, 1e-12);
  const Impact found = impact(mass, {k, e}, v);
  EXPECT_NEAR(found.deepest / deepest, 1.0, 1e-5);
  EXPECT_NEAR(found.strongest / (k * deepest), 1.0, 1e-5);
  EXPECT_NEAR(found.contact, contact, 2e-5);  // two steps
  EXPECT_NEAR(found.speed_out, 0.0600, 1e-6);
}

TEST(SpokeWall, keeps_the_energy_of_a_bit_when_it_restores_all) {
  EXPECT_NEAR(impact(500.0, {1e8, 1.0}, 0.1).speed_out, 0.1, 1e-6);
}

}  // namespace
}  // namespace tdbd::reference::spoke_wall_test
