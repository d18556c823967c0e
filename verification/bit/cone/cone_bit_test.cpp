#include "bit/cone/cone_bit.hpp"

#include <gtest/gtest.h>

#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone_generate.hpp"
#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::bit::cone_bit_test {

/// A fixed cone of two rows with equal spaces.
ConeLayout toothed_symmetric() {
  ConeLayout c;
  c.journal_angle = 36 * degree;
  c.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow inner, gage;
  inner.s = 0.04;
  inner.angles = spaced_angles(8, 0.0, {});
  gage.s = 0.08;
  gage.angles = spaced_angles(12, 0.0, {});
  gage.place = RowPlace::gage;
  c.rows = {inner, gage};
  return c;
}

/// Turned about the cone's axis in the bit's frame: not through the cone's frame.
Vec3 turned_in_bit(const Part& part, const Pose& X_BK, double phi, const Vec3& x_P) {
  const Vec3 s = X_BK.R.col(2);
  return Eigen::AngleAxisd(phi, s).toRotationMatrix() * (part.X_BP * x_P - X_BK.p) + X_BK.p;
}

RC_GTEST_PROP(ConeBit, has_closed_parts_named_by_cone_row_and_tooth, ()) {
  const Bit bit = cone_bit("any", {toothed_cone()}, std::nullopt, {});
  RC_ASSERT(bit.parts.size() == 21u);
  RC_ASSERT(bit.parts[0].name == "cone-1/body");
  RC_ASSERT(bit.parts[1].name == "cone-1/row-1/tooth-1");
  RC_ASSERT(bit.parts[20].name == "cone-1/row-2/tooth-12");
  for (const Part& part : bit.parts) {
    RC_ASSERT(mesh::check_closed(part.mesh_P).empty());
    RC_ASSERT(part.cone == 0);
  }
}

/// The teeth at the gage come to the gage radius, exactly and no farther, as their cone turns.
RC_GTEST_PROP(ConeBit, reaches_the_gage_radius_in_a_turn, ()) {
  const double gage = number(0.09, 0.13);
  const ConeLayout layout = toothed_cone();
  const Bit bit = cone_bit("any", {layout}, gage, {});
  const Cone& cone = bit.cones[0];
  RC_ASSERT(std::abs(bit.gage_radius - gage) < 1e-14);
  const Meridian row = row_meridian(cone.layout, cone.layout.rows[1]);
  const double best = reach_of(cone.X_BK, row).angle;
  double largest = 0.0, widest = 0.0, deepest = -1.0;
  for (const Part& part : bit.parts)
    if (part.kind == PartKind::tooth)
      for (const Vec3& x_P : part.mesh_P.positions) {
        const Vec3 x_K = inverse(cone.X_BK) * (part.X_BP * x_P);
        const double own = std::atan2(x_K.y(), x_K.x());
        largest =
            std::max(largest, turned_in_bit(part, cone.X_BK, best - own, x_P).head<2>().norm());
        for (int k = 0; k < 24; ++k) {
          const Vec3 x_B = turned_in_bit(part, cone.X_BK, 2 * pi * k / 24, x_P);
          widest = std::max(widest, x_B.head<2>().norm());
          deepest = std::max(deepest, x_B.z());
        }
      }
  RC_ASSERT(widest < gage + 1e-14);
  RC_ASSERT(std::abs(largest - gage) < 1e-14);
  RC_ASSERT(deepest < 1e-14 && deepest > -1e-3);
}

/// A cylinder of steel about the journal: closed forms of mass and axial inertia with order 2, no
/// asymmetry, the centre on the axis.
TEST(ConeBit, has_the_mass_properties_of_a_cylinder) {
  const auto error = [](int segments) {
    ConeLayout c;
    c.shell = {{0.02, 0.05}, {0.08, 0.05}};
    c.segments = segments;
    Bit bit;
    bit.cones.push_back({"cone-1", c, {}});
    bit.parts = cone_parts(bit.cones[0], 0);
    const ConeMass m = cone_mass(bit, 0);
    EXPECT_LT(m.asymmetry, 1e-12);
    EXPECT_LT(m.centre_off_axis, 1e-15);
    EXPECT_NEAR(m.body_K.centre.z(), -0.05, 1e-15);
    const double mass = 7850.0 * pi * 0.05 * 0.05 * 0.06;
    return std::pair(std::abs(m.body_K.mass / mass - 1.0),
                     std::abs(m.axial_inertia / (0.5 * mass * 0.05 * 0.05) - 1.0));
  };
  for (const int n : {32, 64, 128}) {
    EXPECT_NEAR(std::log2(error(n).first / error(2 * n).first), 2.0, 0.006);
    EXPECT_NEAR(std::log2(error(n).second / error(2 * n).second), 2.0, 0.018);
  }
}

/// A cone whose shell meets the axis: mass and Ic = 3/10 m r^2 of a solid cone, order 2.
TEST(ConeBit, has_the_mass_properties_of_a_solid_cone) {
  const auto error = [](int segments) {
    ConeLayout c;
    c.shell = {{0.0, 0.0}, {0.08, 0.06}};
    c.segments = segments;
    const MassProperties p = mass_properties(shell_mesh(c), 7850.0);
    EXPECT_NEAR(p.centre.z(), -0.06, 1e-15);
    return std::abs(p.inertia(2, 2) / (0.3 * 7850.0 * pi * 0.06 * 0.06 * 0.08 / 3 * 0.06 * 0.06) -
                    1.0);
  };
  for (const int n : {32, 64, 128}) EXPECT_NEAR(std::log2(error(n) / error(2 * n)), 2.0, 0.018);
}

/// Equal teeth of unequal spacing throw the centre off the axis; equal spacing does not.
TEST(ConeBit, measures_the_asymmetry_of_unequal_spacing) {
  ConeLayout c = toothed_symmetric();
  const double equal = cone_mass(cone_bit("a", {c}, std::nullopt, {}), 0).centre_off_axis;
  c.rows[0].angles = spaced_angles(8, 0.0, {1, 1, 1, 1, 1.4, 1.4, 1, 1});
  const ConeMass unequal = cone_mass(cone_bit("a", {c}, std::nullopt, {}), 0);
  EXPECT_LT(equal, 1e-15);
  EXPECT_GT(unequal.centre_off_axis, 1e-5);
  EXPECT_GT(unequal.asymmetry, 1e-5);
}

/// Two opposite teeth: the difference of the transverse principal inertias, whatever their azimuth.
TEST(ConeBit, measures_the_difference_of_the_transverse_inertias) {
  ConeLayout c = toothed_symmetric();
  c.rows.erase(c.rows.begin());
  const auto measured = [&](double first) {
    c.rows[0].angles = {first, first + pi};
    return cone_mass(cone_bit("a", {c}, std::nullopt, {}), 0);
  };
  const ConeMass m = measured(0.4);
  const Eigen::Matrix2d across = m.body_K.inertia.topLeftCorner<2, 2>();
  const Eigen::Vector2d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(across).eigenvalues();
  EXPECT_NEAR(m.asymmetry, (principal[1] - principal[0]) / m.axial_inertia, 1e-12);
  EXPECT_NEAR(m.asymmetry, measured(0.0).asymmetry, 1e-12);
  EXPECT_GT(m.asymmetry, 0.01);
}

std::string complaint(const std::vector<ConeLayout>& cones, double gage) {
  try {
    cone_bit("any", cones, gage, {});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ConeBit, rejects_what_cannot_reach_its_gage) {
  ConeLayout c = toothed_symmetric();
  EXPECT_EQ(complaint({c}, 0.1), "");
  EXPECT_NE(complaint({c}, 0.02).find("cone-1: offset: found no place along the journal"),
            std::string::npos);
  c.offset = 0.12;
  EXPECT_NE(complaint({c}, 0.1).find("cone-1: offset: found no place along the journal"),
            std::string::npos);
  EXPECT_NE(complaint({}, 0.1).find("found no tooth"), std::string::npos);
}

TEST(ConeBit, rejects_a_body_beyond_its_teeth) {
  ConeLayout c = toothed_symmetric();
  c.shell.back() = {0.12, 0.06};
  c.rows.pop_back();
  EXPECT_NE(complaint({c}, 0.1).find("cone-1: shell: found a body that reaches"),
            std::string::npos);
}

/// Two pointed cones nose to nose on one line: the gap is that of the noses; pushed into one
/// another by d, each nose is d sin(half angle) deep in the other.
TEST(ConeBit, computes_gap_and_overlap_of_two_cones) {
  const auto cones = [](double apex) {
    ConeLayout a;
    a.shell = {{0.01, 0.0}, {0.05, 0.02}};
    a.apex = apex;
    ConeLayout b = a;
    b.azimuth = pi;
    return std::vector<Cone>{{"cone-1", a, cone_pose(a, 0)}, {"cone-2", b, cone_pose(b, 0)}};
  };
  EXPECT_NEAR(cone_clearances(cones(-0.005)).at(0).distance, 0.03, clearance_tolerance);
  const Clearance c = cone_clearances(cones(0.013)).at(0);
  EXPECT_NEAR(c.distance, -0.006 * std::sin(std::atan(0.5)), clearance_tolerance);
  EXPECT_EQ(c.part_a, "cone-1/body");
  EXPECT_EQ(c.part_b, "cone-2/body");
  EXPECT_LE(std::abs(c.place_B.x()), 0.003 + 1e-9);
}

TEST(ConeBit, rejects_two_cones_in_one_place) {
  ConeLayout a;
  a.shell = {{0.01, 0.0}, {0.05, 0.02}};
  const std::vector<Cone> cones{{"cone-1", a, cone_pose(a, 0)}, {"cone-2", a, cone_pose(a, 0)}};
  const Clearance c = cone_clearances(cones).at(0);
  EXPECT_TRUE(is_clash(c));
  EXPECT_EQ(clearance_text(c).find("an overlap of "), 0U) << clearance_text(c);
}

TEST(ConeBit, reports_what_is_undetermined) {
  Clearance c;
  c.part_a = "cone-1/body";
  c.part_b = "cone-2/body";
  c.is_exact = false;
  EXPECT_TRUE(is_clash(c));
  EXPECT_EQ(clearance_text(c).find("cone-1/body and cone-2/body about 0.000 mm apart all over"), 0U)
      << clearance_text(c);
}

RC_GTEST_PROP(ConeSpacing, sums_to_a_turn_in_the_ratios_of_the_pattern, ()) {
  const int teeth = *rc::gen::inRange(2, 30);
  std::vector<double> pattern;
  for (int i = 0; i < *rc::gen::inRange(1, 6); ++i) pattern.push_back(number(0.5, 2.0));
  const std::vector<double> a = spaced_angles(teeth, 0.0, pattern);
  RC_ASSERT(a.size() == static_cast<std::size_t>(teeth));
  double sum = 0.0, ratios = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) ratios += pattern[i % pattern.size()];
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double space = (i + 1 < a.size() ? a[i + 1] : a[0] + 2 * pi) - a[i];
    RC_ASSERT(std::abs(space - 2 * pi * pattern[i % pattern.size()] / ratios) < 1e-14);
    sum += space;
  }
  RC_ASSERT(std::abs(sum - 2 * pi) < 1e-14);
}

RC_GTEST_PROP(ConeSpacing, rises_within_one_turn_from_any_first_angle, ()) {
  const std::vector<double> a = spaced_angles(*rc::gen::inRange(1, 30), number(-20, 20), {1, 2});
  for (std::size_t i = 0; i < a.size(); ++i) {
    RC_ASSERT(a[i] >= 0.0 && a[i] < 2 * pi);
    if (i > 0) RC_ASSERT(a[i] > a[i - 1]);  // RC_ASSERT looks at both sides of an "or"
  }
}

/// A tooth stands on its place of the shell, sunk along the normal there; its Z leans from the normal towards
/// the base, its X is along the meridian; all of it turns with the cone.
RC_GTEST_PROP(ToothPose, is_on_the_shell_and_tilted_towards_the_base, ()) {
  const ConeLayout c = any_cone();
  const std::size_t i = *rc::gen::inRange<std::size_t>(1, c.shell.size());
  const ShellPoint &a = c.shell[i - 1], &b = c.shell[i];
  ToothRow row;
  const double share = number(0.1, 0.9), angle = number(-7.0, 7.0);
  row.s = a.s + share * (b.s - a.s);
  row.sink = number(-2e-3, 2e-3);
  row.lean = number(-0.5, 0.5);
  const Pose X_KT = tooth_pose(c, row, angle);
  const Vec3 radial(std::cos(angle), std::sin(angle), 0.0), base = -Vec3::UnitZ();
  const double length = std::hypot(b.s - a.s, b.r - a.r);
  const Vec3 along = ((b.s - a.s) * base + (b.r - a.r) * radial) / length,
             out = ((b.s - a.s) * radial - (b.r - a.r) * base) / length;
  const Vec3 place = row.s * base + (a.r + share * (b.r - a.r)) * radial - row.sink * out;
  constexpr double rounding = 2e-15;
  RC_ASSERT((X_KT.p - place).norm() < 0.1 * rounding);
  RC_ASSERT((X_KT.R.col(2) - std::cos(row.lean) * out - std::sin(row.lean) * along).norm() <
            rounding);
  RC_ASSERT((X_KT.R.col(0) - std::cos(row.lean) * along + std::sin(row.lean) * out).norm() <
            rounding);
  RC_ASSERT((X_KT.R.col(2).cross(X_KT.R.col(0)) - X_KT.R.col(1)).norm() < rounding);
}

/// A shell of one to six pitches that rises and falls at random.
ConeLayout any_shell() {
  ConeLayout c;
  c.segments = *rc::gen::inRange(8, 60);
  const int pitches = *rc::gen::inRange(1, 7);
  double s = number(-0.02, 0.02);
  for (int i = 0; i <= pitches; ++i) {
    c.shell.push_back({s, i == 0 && *rc::gen::arbitrary<bool>() ? 0.0 : number(0.005, 0.06)});
    s += number(0.002, 0.03);
  }
  return c;
}

RC_GTEST_PROP(ShellPieces, are_convex_and_fill_the_shell, ()) {
  const ConeLayout cone = any_shell();
  double sum = 0.0;
  for (const mesh::TriangleMesh& piece : shell_pieces(cone)) {
    RC_ASSERT(mesh::check_closed(piece).empty());
    RC_ASSERT(mesh::convex_solid(piece).has_value());
    sum += mesh::enclosed_volume(piece);
  }
  const double whole = mesh::enclosed_volume(shell_mesh(cone));
  RC_ASSERT(std::abs(sum - whole) < 1e-13 * whole);
}

}  // namespace tdbd::bit::cone_bit_test

namespace tdbd::bit::part_pose_test {

constexpr double rounding = 1e-14;  ///< of a few products of poses; scale: 1 and 1 m

/// The line through the cone's origin along its axis, and a turn about it by Rodrigues' formula.
Vec3 turned_about_journal(const Cone& cone, const Vec3& x_B, double angle) {
  const Vec3 s = cone.X_BK.R.col(2), d = x_B - cone.X_BK.p;
  return cone.X_BK.p + std::cos(angle) * d + std::sin(angle) * s.cross(d) +
         (1 - std::cos(angle)) * s.dot(d) * s;
}

RC_GTEST_PROP(PartPose, turns_every_part_of_a_cone_about_its_journal, ()) {
  const Bit bit = cone_bit("any", {toothed_cone(), toothed_cone()}, std::nullopt, {0.05, 0.1});
  const std::vector<double> angles{number(-50, 50), number(-50, 50)};
  const Bit there = turned(bit, angles);
  double farthest = 0.0;
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    const Part& part = bit.parts[i];
    const Vec3 x_P(0.01, -0.02, 0.03);
    Vec3 expected = part.X_BP * x_P;
    for (int k = 0; k < 2; ++k)
      if (part.cone == k)
        expected = turned_about_journal(bit.cones[static_cast<std::size_t>(k)], expected,
                                        angles[static_cast<std::size_t>(k)]);
    farthest = std::max(farthest, (part_pose(bit, part, angles) * x_P - expected).norm());
    farthest = std::max(farthest, (there.parts[i].X_BP * x_P - expected).norm());
  }
  RC_ASSERT(farthest < rounding);
}

}  // namespace tdbd::bit::part_pose_test
