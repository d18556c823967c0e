#include "dynamics/drilling/wall_secants.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/battery/generators.hpp"

namespace tdbd::dynamics::wall_secants_test {

using Complex = std::complex<double>;

/// Ten to a power in [lo, hi].
double power_of_ten(double lo, double hi) { return std::pow(10.0, *battery::number(lo, hi)); }

/// A contact that moves by itself, without dampers: mobility A^T M^-1 A of three directions, speeds
/// `start` and accelerations `push` over a time.
struct Contact {
  Mat3 mobility = Mat3::Identity();
  Vec3 start = Vec3::Zero(), push = Vec3::Zero();
  double time = 0.0;
};
WallResponse response_of(const Contact& c) {
  const Complex factor(1.0, -1.0);
  return {c.mobility.cast<Complex>() * (c.time / factor),
          (factor * c.start + (c.time * c.push).cast<Complex>()) / factor};
}

/// Any contact: heavy and light, fast and at rest, pushed hard or not.
Contact any_contact() {
  Contact c;
  Mat3 half = Mat3::Identity();
  for (int i = 0; i < 9; ++i) half(i / 3, i % 3) += *battery::number(-0.5, 0.5);
  c.mobility = power_of_ten(-4.0, 0.0) * half * half.transpose();
  c.start = power_of_ten(-6.0, 1.0) * *battery::point(1.0);
  c.push = power_of_ten(-2.0, 4.0) * *battery::point(1.0);
  c.time = power_of_ten(-6.0, 0.0);
  return c;
}

WallLaw any_law() {
  const double restitution = *rc::gen::element(0.0, 0.3, 0.7, 1.0), e2 = restitution * restitution;
  const double depth_force = power_of_ten(-1.0, 6.0);
  return {*rc::gen::element(0.0, 0.05, 0.5, 2.0), *rc::gen::element(0.0, 1e-6, 1e-3, 1.0),
          0.5 * depth_force * (1.0 + e2), 0.5 * depth_force * (1.0 - e2)};
}

/// By how much the forces of the secants differ from those of the laws at the speeds that they lead
/// to, of the largest force of each law.
double disagreement(const WallLaw& law, const WallResponse& r, const WallSecants& g) {
  const Vec3 v = contact_speeds(r, g).real();
  const double slip = v.head<2>().norm(), v0 = std::max(law.slip_speed, coulomb_creep);
  const double radial = std::abs(v[2]), most = law.spring + law.loss;
  const double lost = law.loss * std::min(radial / radial_creep, 1.0);
  const double normal = law.spring + std::copysign(lost, v[2]);
  const double in_slip = g.slip * slip / most - law.friction * normal / most * std::tanh(slip / v0);
  const double in_radius = (g.radial * radial - lost) / most;
  return std::max(std::abs(in_slip) / std::max(law.friction, 1e-300), std::abs(in_radius));
}

RC_GTEST_PROP(WallSecants, agree_with_the_laws_at_the_speeds_they_lead_to, ()) {
  const WallLaw law = any_law();
  const Contact c = any_contact();
  const WallResponse r = response_of(c);
  SecantSearch search;
  const WallSecants g = find_wall_secants(law, r, c.start, &search);
  RC_CLASSIFY(search.bracketed);
  RC_ASSERT(disagreement(law, r, g) < 2e-10);  // 8e-11 in 20 000 contacts
}

/// A contact at rest that is pushed less than friction bears stays at rest, within its creep.
TEST(WallSecants, hold_a_contact_that_is_pushed_less_than_friction_bears) {
  const WallLaw law{0.5, 1e-3, 1e4, 0.0};                                             // bears 5 kN
  const Contact c{1e-2 * Mat3::Identity(), Vec3::Zero(), Vec3(30.0, 0.0, 0.0), 1.0};  // 3 kN
  SecantSearch search;
  const WallResponse r = response_of(c);
  const WallSecants g = find_wall_secants(law, r, c.start, &search);
  EXPECT_FALSE(search.bracketed);
  EXPECT_NEAR(contact_speeds(r, g).real()[0], 1e-3 * std::atanh(0.6), 6e-5 * 1e-3);
  EXPECT_EQ(g.radial, 0.0);
}

/// Newton's method needs few steps from the speeds of a contact that slides on.
TEST(WallSecants, take_few_newton_steps_where_the_slip_goes_on) {
  const WallLaw law{0.5, 1e-3, 1e4, 5e3};
  const Contact c{1e-3 * Mat3::Identity(), Vec3(0.3, 0.2, 0.05), Vec3(10.0, 0.0, 0.0), 1e-3};
  SecantSearch search;
  const WallSecants g = find_wall_secants(law, response_of(c), c.start, &search);
  EXPECT_FALSE(search.bracketed);
  EXPECT_LE(search.newton_steps, 5);
  const Vec3 v = contact_speeds(response_of(c), g).real();
  EXPECT_NEAR(g.slip * v.head<2>().norm(), 0.5 * 1.5e4, 1e-8);  // moves in: N = spring + loss
  EXPECT_NEAR(g.radial * v[2], 5e3, 1e-8);
}

}  // namespace tdbd::dynamics::wall_secants_test
