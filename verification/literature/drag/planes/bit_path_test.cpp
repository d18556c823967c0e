#include "reference/literature/drag/planes/bit_path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "battery/generators.hpp"

namespace tdbd::reference::bit_path_test {
namespace {

constexpr double pi = std::numbers::pi, mm = 1e-3;

RollingWhirl whirl_of_120_rpm() { return {107.95 * mm, 1.5 * mm, 4 * pi}; }

TEST(RollingWhirl, turns_the_centre_72_times_as_fast_as_the_bit) {
  const RollingWhirl w = whirl_of_120_rpm();
  EXPECT_NEAR(w.whirl_speed() / w.rotary_speed, -71.967, 5e-4);
  EXPECT_NEAR(-w.whirl_speed() / (2 * pi), 143.93, 5e-3);  // Hz
  EXPECT_NEAR(w.lobes(), 72.97, 5e-3);
  const double diameter = 2 * w.bit_radius * (1 - w.rotary_speed / w.whirl_speed());
  EXPECT_NEAR(diameter, 218.900 * mm, 1e-12);
  EXPECT_NEAR(2 * w.hole_radius(), diameter, 1e-15);
}

TEST(RollingWhirl, moves_cutters_backwards_for_a_share_of_time) {
  const RollingWhirl w = whirl_of_120_rpm();
  struct Row {
    double place, share, speed;
  };
  for (const Row& row : {Row{0.25, 0.4196, 1.0157},
                         {0.5, 0.3333, 1.0635},
                         {0.75, 0.2301, 1.1465},
                         {0.99, 0.0451, 1.2670}}) {
    const double r = row.place * w.bit_radius;
    EXPECT_NEAR(backward_share(w, r), row.share, 5e-5);
    EXPECT_NEAR(mean_speed(w, r) / (w.rotary_speed * w.bit_radius), row.speed, 5e-5);
  }
}

/// The closed forms are those of the path: for any point of the bit at any time, by differences.
RC_GTEST_PROP(RollingWhirl, has_the_speeds_of_its_path, ()) {
  const RollingWhirl w{*battery::number(20.0, 200.0) * mm, *battery::number(0.5, 20.0) * mm,
                       *battery::number(0.1, 40.0)};
  const BitPath path = whirl_path(w, 0.0);
  const double r = *battery::number(0.0, 1.0) * w.bit_radius, phi = *battery::number(0.0, 6.3);
  const double t = *battery::number(0.0, 1.0), h = 1e-4 / std::abs(w.whirl_speed());
  const auto place = [&](double time) {
    const BitPlace p = path(time);
    return Vec3(p.p_WB + r * Vec3(std::cos(phi + p.angle), std::sin(phi + p.angle), 0.0));
  };
  const Vec3 v_W = (place(t + h) - place(t - h)) / (2 * h);
  const double at_point = phi + path(t).angle, contact = w.whirl_speed() * t;
  const Vec3 forward(-std::sin(at_point), std::cos(at_point), 0.0);
  const double scale = w.rotary_speed * w.bit_radius, differences = 1e-7 * scale;
  RC_ASSERT(std::abs(v_W.norm() - speed(w, r, contact - at_point)) < differences);
  RC_ASSERT(std::abs(v_W.dot(forward) - forward_speed(w, r, contact - at_point)) < differences);
  RC_ASSERT(speed(w, r, contact - at_point) <= w.rotary_speed * (r + w.bit_radius) * (1 + 1e-12));
}

/// The point of contact rests: there is no slip.
RC_GTEST_PROP(RollingWhirl, rolls_without_slip, ()) {
  const RollingWhirl w{*battery::number(20.0, 200.0) * mm, *battery::number(0.5, 20.0) * mm,
                       *battery::number(0.1, 40.0)};
  RC_ASSERT(speed(w, w.bit_radius, 0.0) == 0.0);
  RC_ASSERT(std::abs(w.whirl_speed() * w.radius + w.rotary_speed * w.bit_radius) <
            1e-14 * w.rotary_speed * w.bit_radius);
}

TEST(SteadyPath, sinks_by_the_advance_in_a_turn) {
  const BitPlace place = steady_path(4 * pi, 3 * mm)(1.25);
  EXPECT_DOUBLE_EQ(place.angle, 5 * pi);
  EXPECT_NEAR(place.p_WB.z(), 7.5 * mm, 1e-15);
  EXPECT_EQ(place.p_WB.head<2>().norm(), 0.0);
}

}  // namespace
}  // namespace tdbd::reference::bit_path_test
