#include "forces/part/directions.hpp"

#include <gtest/gtest.h>

#include "forces/generate.hpp"

namespace tdbd::forces::directions_test {

/// Where a part drills, the frame is the literature's: unit vectors, perpendicular, n in their
/// plane.
RC_GTEST_PROP(CutFrame, is_orthonormal_and_contains_the_normal_where_a_part_drills, ()) {
  const Vec3 n = any_direction();
  const Vec3 along = n.cross(any_direction());
  RC_PRE(along.norm() > 1e-3);
  const double angle = number(0.0, 59 * degree);  // of motion into the rock
  const Vec3 v = number(1e-3, 2.0) * (std::cos(angle) * along.normalized() + std::sin(angle) * n);
  const CutFrame f = cut_frame(v, n);
  RC_ASSERT(std::abs(f.e1.norm() - 1.0) < 1e-14);
  RC_ASSERT(std::abs(f.e2.norm() - 1.0) < 1e-14);
  RC_ASSERT(std::abs(f.e1.dot(f.e2)) < 1e-14);
  RC_ASSERT((v.normalized() - f.e1).norm() < 1e-14);
  RC_ASSERT((n - n.dot(f.e1) * f.e1 - n.dot(f.e2) * f.e2).norm() < 1e-14);
}

/// No jump anywhere but at rest: a small change of velocity changes the frame little.
RC_GTEST_PROP(CutFrame, is_continuous_in_the_velocity, ()) {
  const Vec3 n = any_direction(), v = any_direction();
  const CutFrame a = cut_frame(v, n), b = cut_frame(v + 1e-7 * any_direction(), n);
  // Slopes: of e1 1/|v| and of its removed part; of e2 at most 1/(0.5) of the same.
  RC_ASSERT((a.e1 - b.e1).norm() < 2e-7);
  RC_ASSERT((a.e2 - b.e2).norm() < 5e-7);
}

TEST(CutFrame, at_rest_is_the_normal_alone) {
  const CutFrame f = cut_frame(Vec3::Zero(), Vec3(0, 0, 1));
  EXPECT_EQ(f.e1, Vec3::Zero());
  EXPECT_EQ(f.e2, Vec3(0, 0, 1));
}

TEST(CutFrame, of_a_plunge_pushes_back_alone) {
  const CutFrame f = cut_frame(Vec3(0, 0, 0.3), Vec3(0, 0, 1));
  EXPECT_EQ(f.e1, Vec3(0, 0, 1));
  EXPECT_EQ(f.e2, Vec3::Zero());
}

/// At any speed: what rounding leaves of the slip is none, whatever the unit of length.
TEST(CutFrame, of_a_plunge_askew_by_rounding_is_that_of_a_plunge_at_any_speed) {
  const Vec3 normal = Vec3(0.48, -0.64, 0.6);  // of length 1 but for rounding
  for (const double speed : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
    const CutFrame f = cut_frame(speed * normal, normal);
    EXPECT_LT((f.e1 - normal).norm(), 1e-15) << speed;
    EXPECT_EQ(f.e2, Vec3::Zero()) << speed;
  }
}

/// A part that leaves along the normal is let go; one that leaves askew feels no pull.
TEST(CutFrame, of_a_part_that_leaves_the_rock_has_no_load_along_the_normal) {
  const CutFrame straight = cut_frame(Vec3(0, 0, -0.3), Vec3(0, 0, 1));
  EXPECT_EQ(straight.e1, Vec3::Zero());
  EXPECT_EQ(straight.e2, Vec3::Zero());
  const CutFrame askew = cut_frame(Vec3(0.3, 0, -0.3), Vec3(0, 0, 1));
  EXPECT_NEAR(askew.e1.z(), 0.0, 1e-16);
  EXPECT_NEAR(askew.e1.x(), std::sqrt(0.5), 1e-15);
}

/// A face with this back and side rake that moves along t; n is the normal into the rock.
struct LeaningFace {
  Vec3 t, n, face_normal;
};

LeaningFace leaning_face(double back_rake, double side_rake) {
  LeaningFace f;
  f.n = any_direction();
  const Vec3 across = f.n.cross(any_direction());
  RC_PRE(across.norm() > 1e-3);
  f.t = across.normalized();
  const Vec3 x = std::cos(back_rake) * f.t + std::sin(back_rake) * f.n;
  const Vec3 z = std::sin(back_rake) * f.t - std::cos(back_rake) * f.n;
  f.face_normal = std::cos(side_rake) * x + std::sin(side_rake) * z.cross(x);
  return f;
}

/// Without side rake it is the size of the table's, less the angle of the motion into the rock.
RC_GTEST_PROP(EffectiveBackRake, is_the_size_of_rake_less_helix, ()) {
  const double rake = number(-60 * degree, 60 * degree), helix = number(0.0, 25 * degree);
  RC_PRE(std::abs(rake - helix) > 1 * degree);
  const LeaningFace f = leaning_face(rake, 0.0);
  const double speed = number(1e-3, 2.0);
  const Vec3 v = speed * (std::cos(helix) * f.t + std::sin(helix) * f.n);
  RC_ASSERT(std::abs(effective_back_rake(f.face_normal, v) - std::abs(rake - helix)) < 1e-12);
}

/// The cosines of back rake and side rake multiply.
RC_GTEST_PROP(EffectiveBackRake, counts_side_rake, ()) {
  const double rake = number(2 * degree, 40 * degree), side = number(-20 * degree, 20 * degree);
  const LeaningFace f = leaning_face(rake, side);
  const double angle = std::acos(std::cos(rake) * std::cos(side));
  RC_ASSERT(std::abs(effective_back_rake(f.face_normal, f.t) - angle) < 1e-12);
}

TEST(EffectiveBackRake, at_rest_is_none_and_backwards_a_right_angle) {
  const Vec3 t(1, 0, 0);
  EXPECT_EQ(effective_back_rake(t, Vec3::Zero()), 0.0);
  EXPECT_DOUBLE_EQ(effective_back_rake(t, -t), right_angle);
}

TEST(SlipShare, rises_from_none_at_rest_to_all) {
  EXPECT_EQ(slip_share(0.0, 0.0), 0.0);
  EXPECT_EQ(slip_share(0.0, 1e-3), 0.0);
  EXPECT_NEAR(slip_share(1e-3, 1e-3), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(slip_share(1e-9, 0.0), 1.0);
  EXPECT_NEAR(slip_share(0.5, 1e-3), 1.0 - 2e-6, 1e-11);
}

TEST(FrictionAt, falls_from_its_value_at_rest_to_what_is_left_at_high_speed) {
  const Sliding s{.mu = 0.5, .weakening = 0.4, .weakening_speed = 0.2};
  EXPECT_EQ(friction_at(s, 0.0), 0.5);
  EXPECT_NEAR(friction_at(s, 0.2), 0.5 * (1.0 - 0.4 * (1.0 - std::exp(-1.0))), 1e-15);
  EXPECT_NEAR(friction_at(s, 1e3), 0.3, 1e-15);
  EXPECT_NEAR(friction_at({.mu = 0.5, .weakening = 1.0, .weakening_speed = 0.2}, 1e3), 0.0, 1e-15);
}

/// 100 N at the full stress, without a ramp or a slip speed.
Pressing sharp(double mu) {
  return {.limit = 100.0, .ramp = 0.0, .sliding = {.mu = mu}, .slip_speed = 0.0};
}

/// Pressed into the rock the force is the stress alone; sliding along it Coulomb's; leaving, none.
TEST(PressingForce, pushes_along_the_normal_and_drags_against_the_slip) {
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  c.velocity = Vec3(0, 0, 0.1);
  EXPECT_EQ(pressing_force(c, sharp(0.4)).force, Vec3(0, 0, -100));
  c.velocity = Vec3(0.3, 0.4, 0);
  EXPECT_LT((pressing_force(c, sharp(0.4)).force - Vec3(-24, -32, -100)).norm(), 1e-13);
  c.velocity = Vec3(0.3, 0.4, 0.2);
  EXPECT_LT((pressing_force(c, sharp(0.4)).force - Vec3(-24, -32, -100)).norm(), 1e-13);
  c.velocity = Vec3(0, 0, -0.1);
  EXPECT_LT(pressing_force(c, sharp(0.4)).force.norm(), rounding(100.0));
  c.velocity = Vec3::Zero();
  EXPECT_EQ(pressing_force(c, sharp(0.4)).force, Vec3::Zero());
}

/// A pad that slides and lifts has no force at all: friction is never more than mu times the normal
/// force.
TEST(PressingForce, is_none_where_the_surface_lifts_while_it_slides) {
  PartCut c = plain_cut(bit::PartKind::gage_pad);
  for (const double lift : {1e-6, 0.5, 1.0, 3.0}) {
    c.velocity = Vec3(1e-3, 0.0, -1e-3 * lift);
    EXPECT_EQ(pressing_force(c, sharp(0.5)).force, Vec3::Zero()) << lift;
  }
}

/// Coulomb's law, no pull and no positive work, for every motion and every coefficient.
RC_GTEST_PROP(PressingForce, satisfies_coulombs_law_for_every_motion, ()) {
  PartCut c = plain_cut(bit::PartKind::tooth);
  c.normal = any_direction();
  c.velocity = std::pow(10.0, number(-6.0, 3.0)) * any_direction();
  const double mu = number(0.0, 2.0);
  const Pressing law{.limit = 100.0,
                     .ramp = *rc::gen::element(0.0, 0.01, 0.5),
                     .sliding = {.mu = mu},
                     .slip_speed = *rc::gen::element(0.0, 1e-3)};
  const Vec3 F = pressing_force(c, law).force;
  const double normal = -F.dot(c.normal), tangential = (F + normal * c.normal).norm();
  RC_ASSERT(normal >= -rounding(100.0) && normal <= 100.0 + rounding(100.0));
  RC_ASSERT(tangential <= mu * normal + rounding(100.0));
  RC_ASSERT(F.dot(c.velocity) <= rounding(100.0 * c.velocity.norm()));
}

/// Along the normal, in any direction, rounding leaves some slip: no force may act along it, the
/// sharp law of slip_speed 0 least of all.
RC_GTEST_PROP(PressingForce, has_no_friction_in_a_plunge_or_a_withdrawal, ()) {
  PartCut c = plain_cut(bit::PartKind::tooth);
  c.normal = any_direction();
  const double scale = std::pow(10.0, number(-6.0, 6.0));  // of the unit of speed
  const double speed = scale * number(-2.0, 2.0), beside = std::pow(10.0, -number(8.0, 18.0));
  c.velocity = speed * (c.normal + beside * any_direction());
  const PartForce f = pressing_force(c, sharp(3.0));
  RC_ASSERT(f.force.dot(c.velocity) <= rounding(size(f) * std::abs(speed)));
  if (beside < 1e-15) RC_ASSERT(f.tangential == 0.0);
}

/// A slip that is more than rounding, however small beside the plunge, has its friction.
RC_GTEST_PROP(PressingForce, has_friction_as_soon_as_it_slips, ()) {
  PartCut c = plain_cut(bit::PartKind::tooth);
  c.normal = any_direction();
  const Vec3 across = c.normal.cross(any_direction());
  RC_PRE(across.norm() > 1e-3);
  const double beside = std::pow(10.0, -number(1.0, 13.0));
  const double scale = std::pow(10.0, number(-6.0, 6.0));  // of the unit of speed
  c.velocity = scale * number(0.1, 2.0) * (c.normal + beside * across.normalized());
  const PartForce f = pressing_force(c, sharp(0.4));
  RC_ASSERT(std::abs(f.tangential - 40.0) <= rounding(40.0));
}

}  // namespace tdbd::forces::directions_test
