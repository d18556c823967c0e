#include "simulation/step/loads.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "bit/cutter/cutter.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/case.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::simulation::loads_test {

constexpr double rounding = 1e-12;  // of the forces' and moments' size

/// Bit R: cones beside a body.
const bit::Bit& bit_r() {
  static const bit::Bit bit =
      read_case(TDBD_SOURCE_DIR "/cases/bit-r-steady.toml", {"rock.edge_length='5 mm'"}).bit;
  return bit;
}

ForcePlan any_plan() {
  ForcePlan plan;
  plan.forces = Forces::on;
  forces::Detournay cutting;
  cutting.eps = 1.0;
  cutting.zeta = 0.8;
  forces::Indentation pressing;
  pressing.mu = 0.4;
  plan.laws.fill(pressing);
  plan.laws[static_cast<std::size_t>(bit::PartKind::face)] = cutting;
  plan.rock.strengths.push_back({1.0, 1.0, 0.0, 0.0});
  return plan;
}

BitVelocity any_velocity(const Vec3& p_WB) {
  BitVelocity v{p_WB, *battery::point(1.0), *battery::point(3.0), {}};
  for (std::size_t k = 0; k < bit_r().cones.size(); ++k)
    v.cone_speeds.push_back(*battery::number(-20.0, 20.0));
  return v;
}

/// A cut of a tooth of a cone, or one that is called a face, anywhere about the bit.
CutOfPart any_cut(const forces::Strength& strength) {
  CutOfPart c;
  c.part = *battery::integer(0, static_cast<int>(bit_r().parts.size()) - 1);
  c.cone = bit_r().parts[static_cast<std::size_t>(c.part)].cone;
  c.cut.kind = *battery::integer(0, 1) == 0 ? bit::PartKind::face : bit::PartKind::tooth;
  c.cut.point = *battery::point(1.0);
  c.cut.normal = *battery::direction();
  c.forward_W = *battery::direction();
  c.face_area = c.cut.kind == bit::PartKind::face ? *battery::number(0.0, 1.0) : 0.0;
  c.cut.contact_area = *battery::number(0.0, 1.0);
  c.cut.strength = strength;
  return c;
}

std::vector<CutOfPart> any_cuts(const ForcePlan& plan) {
  std::vector<CutOfPart> cuts;
  for (int k = 0; k < 6; ++k) cuts.push_back(any_cut(plan.rock.strengths.front()));
  return cuts;
}

/// The virtual power of the forces at their points is that of the sums: force, torque about the
/// bit's origin, and torques about the cones' axes. So all levers are right.
RC_GTEST_PROP(Loads, have_the_power_of_their_sums, ()) {
  const ForcePlan plan = any_plan();
  const Pose X_WB = *battery::pose(1.0);
  const BitVelocity v = any_velocity(X_WB.p);
  const std::vector<CutOfPart> cuts = any_cuts(plan);
  BitLoads loads;
  sum_loads(plan, bit_r(), X_WB, v, 1e-3, cuts, loads);
  double power = -loads.force_W.dot(v.v_W) - loads.torque_W.dot(v.w_W), scale = 1.0;
  for (std::size_t k = 0; k < v.cone_speeds.size(); ++k)
    power -= loads.cone_torques[k] * v.cone_speeds[k];
  for (const CutOfPart& c : cuts) scale += cut_at(bit_r(), X_WB, v, 1e-3, c).velocity.norm();
  RC_ASSERT(std::abs(power - loads.power) <= 20.0 * rounding * scale);
  RC_ASSERT(loads.power >= -rounding * scale);
}

CutOfPart turned(CutOfPart c, const Mat3& R) {
  for (Vec3* v : {&c.cut.point, &c.cut.normal, &c.forward_W}) *v = R * *v;
  return c;
}

/// The whole problem turned about z: so are forces and torques.
RC_GTEST_PROP(Loads, turn_with_the_problem, ()) {
  const ForcePlan plan = any_plan();
  const Mat3 R = rotation::exp(Vec3(*battery::number(-3.0, 3.0) * Vec3::UnitZ()));
  const Pose X_WB = *battery::pose(1.0), X_WB_turned{R * X_WB.R, R * X_WB.p};
  const BitVelocity v = any_velocity(X_WB.p);
  const BitVelocity v_turned{R * v.p_WB, R * v.v_W, R * v.w_W, v.cone_speeds};
  std::vector<CutOfPart> cuts = any_cuts(plan), cuts_turned;
  for (const CutOfPart& c : cuts) cuts_turned.push_back(turned(c, R));
  BitLoads loads, loads_turned;
  sum_loads(plan, bit_r(), X_WB, v, 1e-3, cuts, loads);
  sum_loads(plan, bit_r(), X_WB_turned, v_turned, 1e-3, cuts_turned, loads_turned);
  RC_ASSERT((R * loads.force_W - loads_turned.force_W).norm() <= 100.0 * rounding);
  RC_ASSERT((R * loads.torque_W - loads_turned.torque_W).norm() <= 100.0 * rounding);
}

/// A cut's area normal to the velocity, and its rake, from the face's plane.
TEST(Loads, use_the_section_of_a_face_that_moves_forward) {
  CutOfPart c;
  c.cut.kind = bit::PartKind::face;
  c.face_area = 2.0;
  c.cut.engaged_edge = 4.0;
  c.forward_W = Vec3(std::cos(0.3), 0.0, std::sin(0.3));
  const BitVelocity along_x{Vec3::Zero(), Vec3(5.0, 0.0, 0.0), Vec3::Zero(), {}};
  const forces::PartCut cut = cut_at(bit_r(), {}, along_x, 0.01, c);
  EXPECT_NEAR(cut.cut_area, 2.0 * std::cos(0.3), rounding);
  EXPECT_NEAR(cut.back_rake, 0.3, rounding);
  EXPECT_NEAR(cut.path, 0.05, rounding);
  EXPECT_NEAR(cut.depth, 0.5 * std::cos(0.3), rounding);
  const BitVelocity backwards{Vec3::Zero(), Vec3(-5.0, 0.0, 0.0), Vec3::Zero(), {}};
  EXPECT_EQ(cut_at(bit_r(), {}, backwards, 0.01, c).cut_area, 0.0);
}

/// Chamfer of 45 degrees and width w, seen along the profile's normal: w (cos b + sin b). The same
/// from the rim's points in the cutter's frame.
TEST(Loads, of_a_chamfer_are_along_the_normal) {
  bit::Cutter c;
  c.diameter = 16e-3;
  c.tip_radius = 50e-3;
  c.back_rake = 0.35;
  c.chamfer = 0.4e-3;
  c.chamfer_angle = 0.25 * std::numbers::pi;
  const Pose X_BC = bit::cutter_pose(c);
  const Vec3 outer = X_BC * bit::tip_C(c), inner = X_BC * Vec3(0.0, 0.0, c.chamfer - 8e-3);
  const Vec3 n = bit::profile_normal_B(c), across = outer - inner;
  EXPECT_NEAR(chamfer_width(c, c.back_rake), (across - n.dot(across) * n).norm(), rounding);
}

}  // namespace tdbd::simulation::loads_test
