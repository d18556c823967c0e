#include "reference/literature/drag/spokes/hanson_hansen_teeth.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference::hanson_hansen_teeth_test {
namespace {

constexpr double mm = 1e-3, pi = std::numbers::pi;

RollerBit one_tooth() {
  RollerCone cone;
  cone.journal_angle = 36.0 * pi / 180.0;
  cone.offset = 4 * mm;
  cone.inertia = 0.005;
  cone.rows.push_back({80 * mm, 60 * mm, 6 * mm, {0.2}});
  return {{cone}};
}

/// Worked numbers, as printed.
TEST(SphereTooth, is_a_disc_in_the_plane_of_a_spoke) {
  const std::pair<double, double> printed[] = {{0.0, 6.0}, {2.0, 5.656854}, {3.0, 5.196152}};
  for (const auto& [s, radius] : printed) {
    const RimEllipse disc = sphere_section({50 * mm, s * mm, 3 * mm}, 6 * mm, spoke_plane(0, 4));
    EXPECT_NEAR(disc.half_width / mm, radius, 5e-7);
    EXPECT_EQ(disc.half_width, disc.bulge);
  }
  EXPECT_EQ(sphere_section({50 * mm, 7 * mm, 0}, 6 * mm, spoke_plane(0, 4)).half_width, 0.0);
}

TEST(SphereTooth, touches_rock_with_a_cap) {
  constexpr double mm2 = mm * mm, mm3 = mm2 * mm;
  EXPECT_NEAR(sphere_shadow(6 * mm, 1 * mm) / mm2, 34.55752, 5e-6);
  EXPECT_NEAR(sphere_shadow(6 * mm, 1.5 * mm) / mm2, 49.48008, 5e-6);
  EXPECT_NEAR(sphere_surface(6 * mm, 1 * mm) / mm2, 37.69911, 5e-6);
  EXPECT_NEAR(sphere_surface(6 * mm, 1.5 * mm) / mm2, 56.54867, 5e-6);
  EXPECT_NEAR(sphere_cap(6 * mm, 1 * mm) / mm3, 17.80236, 5e-6);
  EXPECT_NEAR(sphere_cap(6 * mm, 1.5 * mm) / mm3, 38.87721, 5e-6);
}

/// The worked number of Ma and Yang's kinematics, with the bit and the cone of that section.
TEST(SphereTooth, has_its_tip_where_the_kinematics_of_cones_say) {
  const RollerBit bit = one_tooth();
  const PlacedTooth t = placed_tooth(sphere_teeth(bit).front(), {}, 0.0, {0, 0, 8.0 / 3600.0},
                                     3.0 * pi, -1.37 * 3.0 * pi);
  EXPECT_NEAR((t.tip_W / mm - Vec3(99.28548039, 15.92015985, 0.55061084)).norm(), 0.0, 2e-8);
  EXPECT_NEAR((t.v_W / mm - Vec3(-59.57649873, 176.46961506, 126.74001635)).norm(), 0.0, 2e-8);
}

RC_GTEST_PROP(SphereTooth, moves_as_its_place_changes, (int turn)) {
  const RollerBit bit = one_tooth();
  const SphereTooth tooth = sphere_teeth(bit).front();
  constexpr double h = 1e-5, bit_rate = 9.0, cone_rate = -13.0;
  const Vec3 v_W(0.1, -0.2, 0.05);
  const double angle = turn % 7;
  const auto at_time = [&](double t) {
    return placed_tooth(tooth, {t * v_W, angle + bit_rate * t}, 0.5 * angle + cone_rate * t, v_W,
                        bit_rate, cone_rate);
  };
  const Vec3 slope = (at_time(h).tip_W - at_time(-h).tip_W) / (2.0 * h);
  RC_ASSERT((slope - at_time(0.0).v_W).norm() < 1e-6);  // third derivatives times h^2: 3e-8
}

TEST(SphereTooth, is_pushed_out_and_rubbed_back) {
  const RollerBit bit = one_tooth();
  const SphereTooth tooth = sphere_teeth(bit).front();
  const PlacedTooth t = placed_tooth(tooth, {}, 0.0, {0, 0, 0.01}, 9.0, -13.0);
  const ToothRock rock{100e6};
  const Vec3 F = tooth_force(rock, 6 * mm, 1 * mm, 1 * mm, t);
  EXPECT_NEAR(-F.dot(t.out_W), 100e6 * 34.55752e-6, 1e-3);
  const Vec3 slip = t.v_W - t.v_W.dot(t.out_W) * t.out_W;
  EXPECT_LT(F.dot(slip), 0.0);
  EXPECT_EQ(tooth_force(rock, 6 * mm, 0.9 * mm, 1.1 * mm, t).norm(), 0.0);
  EXPECT_EQ(tooth_force(rock, 6 * mm, -0.1 * mm, 0.0, t).norm(), 0.0);
}

TEST(SphereTooth, needs_cones_with_teeth_and_inertia) {
  EXPECT_THROW(sphere_teeth({}), InputError);
  RollerBit bit = one_tooth();
  bit.cones.front().inertia = 0.0;
  EXPECT_THROW(sphere_teeth(bit), InputError);
  bit = one_tooth();
  bit.cones.front().rows.clear();
  EXPECT_THROW(sphere_teeth(bit), InputError);
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_teeth_test
