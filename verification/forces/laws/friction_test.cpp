#include "forces/laws/friction.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"

namespace tdbd::forces::friction_test {

Friction pad() {
  Friction f;
  f.stress = 50 * MPa;
  f.mu = 0.3;
  f.slip_speed = 0.0;
  return f;
}

TEST(Friction, of_a_pad_that_slides_along_the_wall_is_none) {
  EXPECT_EQ(force(pad(), plain_cut(bit::PartKind::gage_pad)).force, Vec3::Zero());
}

/// 4 mm2 at 50 MPa: 200 N; half of it at half the slope.
TEST(Friction, grows_with_the_angle_into_the_rock_until_the_stress_is_whole) {
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  for (const auto& [angle, share] : {std::pair{0.5, 0.5}, {1.0, 1.0}, {3.0, 1.0}}) {
    c.velocity = Vec3(1.0, 0.0, angle * std::tan(0.01));
    const PartForce f = force(pad(), c);
    EXPECT_DOUBLE_EQ(f.normal, 200.0 * share) << angle;
    EXPECT_DOUBLE_EQ(f.force.z(), -200.0 * share) << angle;
    EXPECT_DOUBLE_EQ(f.force.x(), -0.3 * 200.0 * share) << angle;
  }
}

TEST(Friction, of_a_flat_without_an_angle_is_whole_while_it_slides) {
  Friction f = pad();
  f.full_angle = 0.0;
  EXPECT_DOUBLE_EQ(force(f, plain_cut(bit::PartKind::bit_body)).normal, 200.0);
}

TEST(Friction, is_capped_by_what_the_rock_carries) {
  Friction f = pad();
  f.full_angle = 0.0;
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  c.strength.confined = 20 * MPa;
  EXPECT_DOUBLE_EQ(force(f, c).normal, 1.5 * 20e6 * 4e-6);
}

TEST(Friction, of_a_pad_pulled_out_is_none) {
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  c.velocity = Vec3(0.0, 0.0, -1.0);
  EXPECT_EQ(force(pad(), c).force, Vec3::Zero());
}

}  // namespace tdbd::forces::friction_test
