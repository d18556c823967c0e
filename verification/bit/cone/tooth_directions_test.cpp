#include "bit/cone/tooth_directions.hpp"

#include <gtest/gtest.h>

#include "bit/cone/cone_bit.hpp"
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
