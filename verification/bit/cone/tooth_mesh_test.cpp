#include <gtest/gtest.h>

#include "bit/bit.hpp"
#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_faults.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone_generate.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit::tooth_mesh_test {

RC_GTEST_PROP(ToothMesh, is_closed_convex_and_has_the_requested_height, ()) {
  const ToothShape t = any_tooth();
  RC_PRE(tooth_faults(t).empty());
  const mesh::TriangleMesh m = tooth_mesh(t, 4 * *rc::gen::inRange(2, 9));
  RC_ASSERT(mesh::check_closed(m).empty());
  RC_ASSERT(mesh::convex_solid(m).has_value());
  const mesh::Box box = mesh::bounding_box(m);
  RC_ASSERT(std::abs(box.hi.z() - t.protrusion) < 1e-15);
  RC_ASSERT(box.lo.z() == -t.embedding);
}

/// The longest crest that a tooth may have, on the coarsest mesh.
TEST(ToothMesh, with_a_crest_as_long_as_the_shank_is_convex) {
  ToothShape t;
  t.kind = ToothKind::chisel;
  t.crest_length = t.diameter;
  t.crest_width = 0.1 * t.diameter;
  for (const int facets : {8, 12, 32})
    EXPECT_TRUE(mesh::convex_solid(tooth_mesh(t, facets)).has_value()) << facets << " facets";
}

TEST(ToothMesh, of_a_chisel_is_as_wide_as_its_shank_up_to_the_shell) {
  ToothShape t;
  t.kind = ToothKind::chisel;
  int on_shank = 0;
  for (const Vec3& x : tooth_mesh(t, 12).positions) {
    if (x.z() > 0.0) continue;
    EXPECT_NEAR(std::hypot(x.x(), x.y()), 0.5 * t.diameter, 1e-15);
    ++on_shank;
  }
  EXPECT_EQ(on_shank, 2 * 12);
}

/// Volume and axial inertia of a cylinder with a half-ball on top approach their closed forms with
/// the square of the edge.
TEST(ToothMesh, of_a_half_ball_converges_with_order_2) {
  ToothShape t;
  t.diameter = 2.0;
  t.protrusion = 1.0;
  t.embedding = 3.0;
  const auto error = [&](int facets) {
    const MassProperties p = mass_properties(tooth_mesh(t, facets), 1.0);
    return std::pair(std::abs(p.mass - (3.0 * pi + 2.0 * pi / 3.0)),
                     std::abs(p.inertia(2, 2) - (3.0 * pi / 2.0 + 4.0 * pi / 15.0)));
  };
  for (const int n : {16, 32, 64}) {
    EXPECT_NEAR(std::log2(error(n).first / error(2 * n).first), 2.0, 0.046);
    EXPECT_NEAR(std::log2(error(n).second / error(2 * n).second), 2.0, 0.05);
  }
}

/// Wedge on a box: prismoids have a closed volume.
TEST(ToothMesh, of_a_milled_tooth_has_the_volume_of_its_prismoid) {
  ToothShape t;
  t.kind = ToothKind::milled_chisel;
  const auto area = [&](double up) {
    return (t.diameter + up * (t.crest_length - t.diameter)) *
           (t.width + up * (t.crest_width - t.width));
  };
  const double wedge = t.protrusion / 6.0 * (area(0) + 4 * area(0.5) + area(1));
  EXPECT_NEAR(mesh::enclosed_volume(tooth_mesh(t, 16)), t.embedding * area(0) + wedge, 1e-20);
}

/// Volume of a shank, a frustum and a ball's cap, which is what a conical insert is: to second order.
TEST(ToothMesh, of_a_conical_insert_converges_with_order_2) {
  ToothShape t;
  t.kind = ToothKind::conical;
  t.diameter = 2.0;
  t.protrusion = 1.6;
  t.embedding = 1.0;
  t.tip_radius = 0.5;
  t.half_angle = 0.6;
  const double c = std::cos(0.6), s = std::sin(0.6), r = 0.5 * c;  // where flank and ball touch
  const double flank = (1.0 - r) / std::tan(0.6), cap = 0.5 * (1.0 - s),
               shank = 1.0 + 1.6 - cap - flank;
  const double volume =
      pi * shank + pi * flank / 3.0 * (1.0 + r + r * r) + pi * cap * cap / 3.0 * (3.0 * 0.5 - cap);
  const auto error = [&](int facets) {
    return volume - mesh::enclosed_volume(tooth_mesh(t, facets));
  };
  EXPECT_GT(error(32), 0.0);  // inscribed
  for (const int n : {16, 32, 64}) EXPECT_NEAR(std::log2(error(n) / error(2 * n)), 2.0, 0.025);
}

/// The bounding box of the top of a tooth.
Vec3 crest_of(const mesh::TriangleMesh& m, double top) {
  mesh::TriangleMesh crest;
  for (const Vec3& x : m.positions)
    if (x.z() > top - 1e-9) crest.positions.push_back(x);
  return mesh::bounding_box(crest).size();
}

/// A crest has the requested length along X and width along Y, that of a chisel up to the facets of
/// its shank.
TEST(ToothMesh, has_the_requested_crest) {
  ToothShape t;
  t.kind = ToothKind::milled_chisel;
  const Vec3 milled = crest_of(tooth_mesh(t, 16), t.protrusion);
  EXPECT_NEAR(milled.x(), t.crest_length, 1e-15);
  EXPECT_NEAR(milled.y(), t.crest_width, 1e-15);
  t.kind = ToothKind::chisel;
  for (const int facets : {8, 16, 64}) {
    const double short_of = std::cos(pi / facets);
    const Vec3 chisel = crest_of(tooth_mesh(t, facets), t.protrusion);
    EXPECT_NEAR(chisel.x(), t.crest_length * short_of, 1e-15);
    EXPECT_NEAR(chisel.y(), t.crest_width * short_of, 1e-15);
  }
}

/// The requested number of facets around, and a quarter as many rings up a ball, at least two.
TEST(ToothMesh, has_the_requested_number_of_facets) {
  ToothShape t;
  for (const int facets : {8, 16, 32}) {
    const auto n = static_cast<std::size_t>(facets), rings = std::max<std::size_t>(2, n / 4);
    t.kind = ToothKind::hemispherical;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), n * (1 + rings) + 1);
    t.kind = ToothKind::conical;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), n * (2 + rings) + 1);
    t.kind = ToothKind::chisel;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), 3 * n);
    t.kind = ToothKind::milled_chisel;
    EXPECT_EQ(tooth_mesh(t, facets).positions.size(), 12U);
  }
}

std::string first_fault(const ToothShape& t) {
  const auto faults = tooth_faults(t);
  return faults.empty() ? "" : faults.front().key;
}

TEST(ToothMesh, has_faults_for_what_no_tooth_can_be) {
  ToothShape t;
  EXPECT_EQ(first_fault(t), "");
  t.diameter = -1e-3;
  EXPECT_EQ(first_fault(t), "diameter");
  t = {};
  t.embedding = -1e-3;
  EXPECT_EQ(first_fault(t), "embedding");
  t = {.protrusion = 1e-3, .embedding = 4e-3};
  EXPECT_EQ(first_fault(t), "embedding") << "the half-ball ends below the shank";
  t = {.kind = ToothKind::chisel, .crest_length = 13e-3};
  EXPECT_EQ(first_fault(t), "crest_length");
  t = {.kind = ToothKind::chisel, .crest_length = 2e-3, .crest_width = 3e-3};
  EXPECT_EQ(first_fault(t), "crest_width");
  t = {.kind = ToothKind::milled_chisel, .width = 1e-3};
  EXPECT_EQ(first_fault(t), "crest_width");
  t = {.kind = ToothKind::conical, .tip_radius = 9e-3};
  EXPECT_EQ(first_fault(t), "tip_radius");
  t = {.kind = ToothKind::conical, .tip_radius = 1e-3, .half_angle = 0.1};
  EXPECT_EQ(first_fault(t), "half_angle");
}

RC_GTEST_PROP(DirectTeeth, moves_rock_straight_down_under_inner_rows, ()) {
  Bit bit = cone_bit("any", {toothed_cone()}, std::nullopt, {});
  const auto rule =
      *rc::gen::element(GageRule::normal, GageRule::row, GageRule::down, GageRule::horizontal);
  set_tooth_directions(bit, rule);
  for (const Part& p : bit.parts)
    if (p.kind == PartKind::tooth && p.row == 0) {
      RC_ASSERT(p.update_direction_B == Vec3(0, 0, 1));
      RC_ASSERT(!p.core_P);
    }
}

RC_GTEST_PROP(DirectTeeth, has_four_rules_at_the_gage, ()) {
  Bit bit = cone_bit("any", {toothed_cone()}, std::nullopt, {});
  const auto gage_tooth = [&](GageRule rule) {
    set_tooth_directions(bit, rule);
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
  set_tooth_directions(bit, GageRule::row);
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
  set_tooth_directions(bit, GageRule::row);
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
    set_tooth_directions(bit, GageRule::normal);
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

}  // namespace tdbd::bit::tooth_mesh_test
