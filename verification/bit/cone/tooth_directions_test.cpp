#include "bit/cone/tooth_directions.hpp"

#include <gtest/gtest.h>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_frame.hpp"
#include "bit/cone_generate.hpp"

namespace tdbd::bit::tooth_directions_test {

RC_GTEST_PROP(DirectTeeth, moves_rock_straight_down_under_inner_rows, ()) {
  Bit bit = cone_bit("any", {toothed_cone()}, std::nullopt, {});
  const auto rule =
      *rc::gen::element(GageRule::normal, GageRule::row, GageRule::down, GageRule::horizontal);
  direct_teeth(bit, rule);
  for (const Part& p : bit.parts)
    if (p.kind == PartKind::tooth && p.row == 0) {
      RC_ASSERT(p.update_direction_B == Vec3(0, 0, 1));
      RC_ASSERT(!p.core_P);
    }
}

RC_GTEST_PROP(DirectTeeth, knows_four_rules_at_the_gage, ()) {
  Bit bit = cone_bit("any", {toothed_cone()}, std::nullopt, {});
  const auto gage_tooth = [&](GageRule rule) {
    direct_teeth(bit, rule);
    return bit.parts.back();
  };
  RC_ASSERT(gage_tooth(GageRule::down).update_direction_B == Vec3(0, 0, 1));
  RC_ASSERT(gage_tooth(GageRule::horizontal).update_direction_B == Vec3(1, 0, 0));
  const Vec3 row = gage_tooth(GageRule::row).update_direction_B;
  RC_ASSERT(row.x() >= 0.0 && row.y() == 0.0 && row.z() >= 0.0);
  RC_ASSERT(std::abs(row.norm() - 1.0) < 1e-14);
  RC_ASSERT(!gage_tooth(GageRule::row).core_P);
  RC_ASSERT(gage_tooth(GageRule::normal).core_P.has_value());
}

/// Where the row stands deepest its teeth point along their Z: what of it is outward and downward, and neither up
/// nor inward. Of a journal that meets the bit's axis, by its frame.
RC_GTEST_PROP(DirectTeeth, follows_the_rows_normal_at_its_deepest_place, ()) {
  ConeLayout cone = toothed_cone();
  cone.journal_angle = number(5 * degree, 70 * degree);
  cone.offset = cone.skew = 0.0;
  ToothRow& row = cone.rows[1];
  row.lean = number(-1.5, 1.5);
  Bit bit;
  bit.cones.push_back({"cone-1", cone, cone_pose(cone, 0.0)});
  bit.parts = cone_parts(bit.cones[0], 0);
  direct_teeth(bit, GageRule::row);
  const Mat3& R = bit.cones[0].X_BK.R;
  const Vec3 in_B = R.col(2), down_B = (Vec3::UnitZ() - in_B.z() * in_B).normalized(),
             out_B = -Vec3(in_B.x(), in_B.y(), 0.0).normalized();
  const Vec3 z_K = tooth_pose(cone, row, 0.0).R.col(2);
  const Vec3 z_B = z_K.x() * down_B + z_K.z() * in_B;
  Vec3 expected(std::max(0.0, out_B.dot(z_B)), 0.0, std::max(0.0, z_B.z()));
  if (expected.norm() == 0.0)
    expected = Vec3::UnitZ();
  else
    RC_PRE(expected.norm() > 1e-3);
  RC_ASSERT((bit.parts.back().update_direction_B - expected.normalized()).norm() < 1e-12);
}

/// Up and inward at once: straight down then.
TEST(DirectTeeth, goes_down_where_a_row_points_up_and_inward) {
  ConeLayout cone;
  cone.journal_angle = 36 * degree;
  cone.shell = {{0.01, 0.01}, {0.04, 0.03}};
  ToothRow row;
  row.s = 0.02;
  row.place = RowPlace::gage;
  row.angles = {0.0};
  row.lean = -2.5;
  cone.rows = {row};
  Bit bit;
  bit.cones.push_back({"cone-1", cone, cone_pose(cone, 0.0)});
  bit.parts = cone_parts(bit.cones[0], 0);
  direct_teeth(bit, GageRule::row);
  EXPECT_EQ(bit.parts.back().update_direction_B, Vec3(Vec3::UnitZ()));
}

/// From the lower end to the centre of the round end, or no farther than the lower end.
TEST(DirectTeeth, puts_the_core_on_the_tooths_axis) {
  ConeLayout cone;
  cone.shell = {{0.01, 0.01}, {0.04, 0.03}};
  ToothRow row;
  row.s = 0.02;
  row.place = RowPlace::gage;
  row.angles = {0.0};
  row.shape = {.diameter = 12e-3, .protrusion = 7e-3, .embedding = 4e-3};
  for (const auto& [protrusion, top] : {std::pair{7e-3, 1e-3}, {3e-3, -3e-3}, {1e-3, -4e-3}}) {
    row.shape.protrusion = protrusion;
    cone.rows = {row};
    Bit bit;
    bit.cones.push_back({"cone-1", cone, cone_pose(cone, 0.0)});
    bit.parts = cone_parts(bit.cones[0], 0);
    direct_teeth(bit, GageRule::normal);
    const Segment core = bit.parts.back().core_P.value();
    EXPECT_EQ(core.from, Vec3(0.0, 0.0, -4e-3));
    EXPECT_NEAR(core.to.z(), top, 1e-17);
    EXPECT_EQ(core.to.head<2>().norm(), 0.0);
  }
}

/// The round end of an insert with a half-ball is its own: the core ends at the ball's centre, from
/// which every corner of the cap is half a diameter away.
RC_GTEST_PROP(DirectTeeth, centres_the_core_in_the_half_ball, ()) {
  ConeLayout cone = toothed_cone();
  cone.rows[1].shape = ToothShape{};
  const Bit bit = cone_bit("any", {cone}, std::nullopt, {});
  const Part& tooth = bit.parts.back();
  RC_ASSERT(tooth.core_P.has_value());
  const ToothShape& shape = cone.rows[1].shape;
  for (const Vec3& x_T : tooth.mesh_P.positions) {
    if (x_T.z() <= tooth.core_P->to.z()) continue;
    RC_ASSERT(std::abs((x_T - tooth.core_P->to).norm() - 0.5 * shape.diameter) < 1e-15);
  }
}

}  // namespace tdbd::bit::tooth_directions_test
