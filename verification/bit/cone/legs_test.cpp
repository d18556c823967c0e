#include "bit/cone/legs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/bit.hpp"
#include "bit/body/bit_body.hpp"
#include "bit/cone/cone_bit.hpp"
#include "bit/cone_generate.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"

namespace tdbd::bit::legs_test {
namespace {

/// Three cones at the gage radius 0.1 m, shank of 60 mm from 110 mm upwards.
Bit toothed_bit(double offset, double skew) {
  ConeLayout c;
  c.journal_angle = 36 * degree;
  c.offset = offset;
  c.skew = skew;
  c.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  ToothRow gage;
  gage.s = 0.08;
  gage.angles = spaced_angles(12, 0.1, {1.0, 1.2});
  gage.place = RowPlace::gage;
  c.rows = {gage};
  std::vector<ConeLayout> cones{c, c, c};
  cones[1].azimuth = 120 * degree;
  cones[2].azimuth = -120 * degree;
  return cone_bit("any", cones, 0.1, {.radius = 0.06, .length = 0.15, .height = 0.11});
}

Legs sound_legs() {
  Legs l;
  l.width = 0.05;
  l.tip_radius = 0.033;
  l.shoulder = 0.12;
  l.top = 0.16;
  return l;
}

Bit legged(const Bit& bit, const Legs& legs, int slices = usual_leg_slices) {
  Bit b = bit;
  EXPECT_TRUE(leg_faults(b, legs).empty());
  add_legs(b, legs, slices);
  return b;
}

Bit any_bit() { return toothed_bit(number(-6e-3, 6e-3), number(-3 * degree, 3 * degree)); }

Legs any_legs() {
  Legs l = sound_legs();
  l.width = number(0.03, 0.05);
  l.under_gage = number(1e-3, 3e-3);
  l.clearance = number(1e-3, 4e-3);
  l.tip_radius = number(0.028, 0.036);
  l.shoulder = number(0.09, 0.13);
  l.top = l.shoulder + number(0.022, 0.1);
  l.cutting = *rc::gen::element(Cutting::rubs, Cutting::never);
  l.inserts = *rc::gen::inRange(0, 4);
  return l;
}

const Part& leg_of(const Bit& bit, int leg = 1) {
  return *std::ranges::find(bit.parts, "leg-" + std::to_string(leg), &Part::name);
}

RC_GTEST_PROP(Legs, are_closed_parts_after_all_others, ()) {
  const Bit bare = any_bit();
  const Legs legs = any_legs();
  RC_PRE(leg_faults(bare, legs).empty());
  const Bit bit = legged(bare, legs);
  const auto inserts = static_cast<std::size_t>(legs.inserts);
  RC_ASSERT(bit.parts.size() == bare.parts.size() + 3 * (1 + inserts));
  for (std::size_t i = 0; i < bare.parts.size(); ++i)
    RC_ASSERT(bit.parts[i].name == bare.parts[i].name);
  RC_ASSERT(bit.gage_radius == bare.gage_radius);
  for (std::size_t i = bare.parts.size(); i < bit.parts.size(); ++i) {
    const Part& p = bit.parts[i];
    const std::size_t leg = (i - bare.parts.size()) / (1 + inserts) + 1,
                      insert = (i - bare.parts.size()) % (1 + inserts);
    RC_ASSERT(p.name == "leg-" + std::to_string(leg) +
                            (insert > 0 ? "/insert-" + std::to_string(insert) : ""));
    RC_ASSERT(p.kind == (insert > 0 ? PartKind::gage_pad : PartKind::bit_body));
    RC_ASSERT(p.cutting == legs.cutting);
    RC_ASSERT(mesh::check_closed(p.mesh_P).empty());
    RC_ASSERT(mesh::enclosed_volume(p.mesh_P) > 0.0);
    for (const Vec3& x_P : p.mesh_P.positions)
      RC_ASSERT((p.X_BP * x_P).head<2>().norm() <= bit.gage_radius);
  }
}

/// Depth inside a leg below the nearest of its bounds (m), computed without its mesh; negative
/// outside.
double depth_in_leg(const Bit& bit, std::size_t cone, const Legs& legs, const Vec3& x_B) {
  const Pose& X_BK = bit.cones[cone].X_BK;
  const Vec3 s = -X_BK.R.col(2), from = x_B - X_BK.p;
  const Vec3 across = Vec3::UnitZ().cross(s).normalized();
  const Vec3 down = s.cross(across);
  const double u = from.dot(across), t = from.dot(down);
  const double above = bit.shank.height, height = -x_B.z(), r = x_B.head<2>().norm();
  const double outer = bit.gage_radius - legs.under_gage;
  double depth =
      std::min({0.5 * legs.width - std::abs(u),
                from.dot(s) - bit.cones[cone].layout.shell.back().s - legs.clearance, outer - r,
                legs.top - height, Vec3(s.x(), s.y(), 0).normalized().dot(x_B)});
  if (t > 0.0) depth = std::min(depth, legs.tip_radius - std::hypot(u, t));
  if (height > above) depth = std::min(depth, r - bit.shank.radius);
  if (height > legs.shoulder) {  // the lean, in the plane of constant distance from the journal
    const double y = across.dot(Vec3(x_B.x(), x_B.y(), 0));
    const double x = std::sqrt(r * r - y * y),
                 at = (height - legs.shoulder) / (legs.top - legs.shoulder);
    const double lean = std::sqrt(outer * outer - y * y) * (1.0 - at) +
                        std::sqrt(bit.shank.radius * bit.shank.radius - y * y) * at;
    depth = std::min(depth, lean - x);
  }
  return depth;
}

/// Points at random in the leg's box, but those nearer to a bound than curved sides are inscribed: the
/// shank's 48 corners make the most, 60 mm (1 - cos(pi/48)).
RC_GTEST_PROP(Legs, contain_the_points_between_their_bounds, ()) {
  constexpr double inscribed = 0.3e-3;  // m
  const Bit bare = any_bit();
  const Legs legs = any_legs();
  RC_PRE(leg_faults(bare, legs).empty());
  const Bit bit = legged(bare, legs);
  const int leg = *rc::gen::inRange(1, 4);
  const mesh::TriangleMesh m = mesh_B(leg_of(bit, leg));
  const mesh::TriangleTree tree(m);
  const mesh::Box box = mesh::bounding_box(m);
  int in = 0, out = 0;
  for (int k = 0; k < 60; ++k) {
    const Vec3 x(number(box.lo.x(), box.hi.x()), number(box.lo.y(), box.hi.y()),
                 number(box.lo.z(), box.hi.z()));
    const double depth = depth_in_leg(bit, static_cast<std::size_t>(leg - 1), legs, x);
    if (std::abs(depth) < inscribed) continue;
    ++(depth > 0.0 ? in : out);
    RC_ASSERT(mesh::inside(tree, x) == (depth > 0.0));
  }
  RC_CLASSIFY(in > 0 && out > 0, "points on both sides");
}

/// They touch the shank's mesh, along its lower end and its side, and share no volume with it.
RC_GTEST_PROP(Legs, touch_the_shank, ()) {
  const Bit bare = any_bit();
  const Legs legs = any_legs();
  RC_PRE(leg_faults(bare, legs).empty());
  const Bit bit = legged(bare, legs);
  const Part& shank = *std::ranges::find(bit.parts, "bit-body", &Part::name);
  const double whole = mesh::enclosed_volume(leg_of(bit).mesh_P);
  constexpr double rounding = 1e-12;  // of the leg's volume
  RC_ASSERT(std::abs(common_volume(shank.mesh_P, mesh_B(leg_of(bit)))) < rounding * whole);
  mesh::TriangleMesh nearer = mesh_B(leg_of(bit));  // moved into the shank, from outside and below
  constexpr double by = 1e-4;                       // m
  const Vec3 out = leg_of(bit).X_BP.R.col(0);
  for (Vec3& x : nearer.positions) x -= by * (out + Vec3::UnitZ());
  const double side = legs.width * (legs.top - bit.shank.height) * by;
  RC_ASSERT(common_volume(shank.mesh_P, nearer) > 0.9 * side);
}

/// The area of a slice at constant distance from the journal, by the corners' coordinates, without the
/// mesh; Simpson's rule across the width. Of the true cylinders, but for the shank's 48 corners.
double volume_of(const Bit& bit, const Legs& legs) {
  const auto side_of_shank = [&](double y) {
    const double corner = full_turn / 48, R = bit.shank.radius;
    const double k = std::floor(std::asin(y / R) / corner);
    const double y0 = R * std::sin(k * corner), y1 = R * std::sin((k + 1) * corner);
    const double x0 = R * std::cos(k * corner), x1 = R * std::cos((k + 1) * corner);
    return x0 + (y - y0) / (y1 - y0) * (x1 - x0);
  };
  const Cone& cone = bit.cones[0];
  const double J = cone.layout.journal_angle, R = bit.gage_radius - legs.under_gage;
  const Vec3 s(std::cos(J), 0.0, -std::sin(J));
  const Vec3 base = cone.X_BK.p + (cone.layout.shell.back().s + legs.clearance) * s;
  const auto area = [&](double u) {
    const double y = base.y() + u, outer = std::sqrt(R * R - y * y), side = side_of_shank(y);
    const double t = std::sqrt(legs.tip_radius * legs.tip_radius - u * u);
    const double h0 = -base.z(), low_x = base.x() + t * std::sin(J), low_h = h0 - t * std::cos(J);
    const double inner = base.x() - (bit.shank.height - h0) * std::tan(J);
    const double edge_h = low_h + (outer - low_x) * std::tan(J);
    const double x[] = {low_x, outer, outer, side, side, inner},
                 h[] = {low_h, edge_h, legs.shoulder, legs.top, bit.shank.height, bit.shank.height};
    double twice = 0.0;
    for (int i = 0; i < 6; ++i) twice += x[i] * h[(i + 1) % 6] - x[(i + 1) % 6] * h[i];
    return 0.5 * twice;
  };
  constexpr int n = 20000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double du = legs.width / n, u = -0.5 * legs.width + i * du;
    sum += du / 6.0 * (area(u) + 4.0 * area(u + 0.5 * du) + area(u + du));
  }
  return sum;
}

TEST(Legs, have_the_volume_of_their_bounds_to_order_2) {
  const Bit bare = toothed_bit(0.0, 0.0);
  const Legs legs = sound_legs();
  const double exact = volume_of(bare, legs);
  const auto missing = [&](int slices) {
    return 1.0 - mesh::enclosed_volume(leg_of(legged(bare, legs, slices)).mesh_P) / exact;
  };
  EXPECT_NEAR(missing(2048), 0.0, 1e-7);
  for (const int n : {64, 128, 256})
    EXPECT_NEAR(std::log2(missing(n) / missing(2 * n)), 2.0, 0.1) << n << " " << missing(n);
}

TEST(Legs, count_in_the_mass) {
  const Bit bare = toothed_bit(4e-3, 2 * degree);
  Legs legs = sound_legs();
  legs.density = 7000.0;
  legs.inserts = 3;
  const Bit bit = legged(bare, legs);
  double mass = 0.0;
  for (int k = 1; k <= 3; ++k) mass += 7000.0 * mesh::enclosed_volume(leg_of(bit, k).mesh_P);
  EXPECT_NEAR(mass_properties(bit).mass, mass_properties(bare).mass + mass, 1e-12);
}

/// On the outer side's middle, equally spaced from the shirttail's edge to the shoulder; flat faces.
TEST(Legs, have_flush_inserts) {
  const Bit bare = toothed_bit(0.0, 0.0);
  Legs legs = sound_legs();
  legs.inserts = 3;
  legs.insert_diameter = 0.008;
  legs.insert_length = 0.006;
  legs.insert_protrusion = 0.4e-3;
  const Bit bit = legged(bare, legs);
  const double R = bit.gage_radius - legs.under_gage;
  std::vector<double> heights;
  for (int i = 1; i <= 3; ++i) {
    const Part& insert =
        *std::ranges::find(bit.parts, "leg-1/insert-" + std::to_string(i), &Part::name);
    const mesh::Box box = mesh::bounding_box(mesh_B(insert));
    EXPECT_NEAR(box.hi.x(), R + 0.4e-3, 1e-15);
    EXPECT_NEAR(box.lo.x(), R + 0.4e-3 - 0.006, 1e-15);
    EXPECT_NEAR(box.size().z(), 0.008, 1e-15);
    EXPECT_EQ(insert.density, 0.0);
    EXPECT_EQ(insert.update_direction_B, Vec3(Vec3::UnitX()));
    heights.push_back(-0.5 * (box.lo.z() + box.hi.z()));
  }
  double edge = -1.0;  // of the shirttail, in the leg's middle, on the gage
  for (const Vec3& x : mesh_B(leg_of(bit)).positions)
    if (std::abs(x.y()) < 1e-12 && std::abs(x.x() - R) < 1e-12) edge = std::max(edge, x.z());
  const double high = legs.shoulder + edge;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(heights[i], -edge + (i + 0.5) / 3 * high, 1e-12);
}

void expect_leg_fault(const Bit& bit, const Legs& legs, LegTable table, const std::string& text) {
  const std::vector<LegFault> faults = leg_faults(bit, legs);
  ASSERT_FALSE(faults.empty()) << text;
  EXPECT_EQ(faults[0].table, table);
  EXPECT_EQ(faults[0].key + ": found " + faults[0].found + ", expected " + faults[0].expected,
            text);
}

TEST(LegFaults, are_none_of_sound_legs) {
  EXPECT_TRUE(leg_faults(toothed_bit(4e-3, 2 * degree), sound_legs()).empty());
}

TEST(LegFaults, name_a_shank_that_does_not_meet_the_legs) {
  Bit bit = toothed_bit(0.0, 0.0);
  bit.parts.pop_back();
  expect_leg_fault(bit, sound_legs(), LegTable::legs,
                   "width: found 50 mm, legs without a shank, expected [shank] with a radius");
  const auto with = [](Shank shank) {
    const Bit b = toothed_bit(0.0, 0.0);
    std::vector<ConeLayout> cones;
    for (const Cone& c : b.cones) cones.push_back(c.layout);
    return cone_bit("any", cones, 0.1, shank);
  };
  expect_leg_fault(with({.radius = 0.099, .length = 0.15, .height = 0.11}), sound_legs(),
                   LegTable::shank,
                   "radius: found 99 mm, expected less than the gage radius less "
                   "legs.under_gage, 98.4 mm");
  const std::vector<LegFault> low =
      leg_faults(with({.radius = 0.06, .length = 0.15, .height = 0.07}), sound_legs());
  ASSERT_EQ(low.size(), 1U);
  EXPECT_EQ(low[0].table, LegTable::shank);
  EXPECT_EQ(low[0].key, "height");
  EXPECT_EQ(low[0].found.find("70 mm, where the inner side of leg-1 is "), 0U) << low[0].found;
  EXPECT_EQ(low[0].expected.find("a height at which the shank, there 54.4"), 0U) << low[0].expected;
}

TEST(LegFaults, name_heights_out_of_order) {
  const Bit bit = toothed_bit(0.0, 0.0);
  Legs legs = sound_legs();
  legs.top = 0.11;
  expect_leg_fault(bit, legs, LegTable::legs,
                   "top: found 110 mm, expected a height above the shank's lower end, 110 mm, and "
                   "at most its upper one, 260 mm");
  legs.top = 0.261;
  expect_leg_fault(bit, legs, LegTable::legs,
                   "top: found 261 mm, expected a height above the shank's lower end, 110 mm, and "
                   "at most its upper one, 260 mm");
  legs.top = 0.12;
  legs.shoulder = 0.1201;
  ASSERT_EQ(leg_faults(bit, legs).size(), 1U);
  EXPECT_EQ(leg_faults(bit, legs)[0].key, "shoulder");
  legs.shoulder = 0.02;
  const std::vector<LegFault> low = leg_faults(bit, legs);
  ASSERT_EQ(low.size(), 1U);
  EXPECT_EQ(low[0].found, "20 mm");
  EXPECT_EQ(low[0].expected.find("a height above the shirttail's, "), 0U) << low[0].expected;
}

TEST(LegFaults, name_legs_that_are_too_wide) {
  const Bit bit = toothed_bit(0.0, 0.0);
  Legs legs = sound_legs();
  legs.tip_radius = 0.024;
  expect_leg_fault(bit, legs, LegTable::legs,
                   "width: found 50 mm, expected at most twice the shirttail's radius, 24 mm");
  legs.tip_radius = 0.062;
  legs.width = 0.122;
  expect_leg_fault(bit, legs, LegTable::legs,
                   "width: found 122 mm, of a leg that reaches 61 mm from the plane through the "
                   "bit's axis, expected a leg narrower than the shank");
}

TEST(LegFaults, name_a_shirttail_outside_the_gage) {
  Legs legs = sound_legs();
  legs.tip_radius = 0.08;
  const std::vector<LegFault> faults = leg_faults(toothed_bit(0.0, 0.0), legs);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].key, "tip_radius");
  EXPECT_EQ(faults[0].found.find("80 mm, a shirttail that reaches "), 0U) << faults[0].found;
  EXPECT_EQ(faults[0].expected, "one inside the gage radius less under_gage, 98.4 mm");
}

TEST(LegFaults, name_inserts_that_do_not_fit) {
  const Bit bit = toothed_bit(0.0, 0.0);
  Legs legs = sound_legs();
  legs.inserts = 20;
  ASSERT_EQ(leg_faults(bit, legs).size(), 3U - 2U);
  EXPECT_EQ(leg_faults(bit, legs)[0].key, "inserts");
  EXPECT_EQ(leg_faults(bit, legs)[0].found, "20 of 9.5 mm");
  EXPECT_EQ(leg_faults(bit, legs)[0].expected.find("at most "), 0U);
  legs.inserts = 2;
  legs.insert_protrusion = 1.6e-3;
  expect_leg_fault(bit, legs, LegTable::legs,
                   "insert_protrusion: found 1.6 mm, inserts that reach 100.113 mm from the bit's "
                   "axis, expected inserts that stay inside the gage radius, 100 mm");
}

TEST(LegFaults, name_journals_that_are_too_steep) {
  Bit bit = toothed_bit(0.0, 0.0);
  bit.cones[1].layout.journal_angle = 80 * degree;
  bit.cones[1].X_BK.R = Eigen::AngleAxisd(-10 * degree, Vec3::UnitY()).toRotationMatrix();
  expect_leg_fault(bit, sound_legs(), LegTable::cone,
                   "journal_angle: found 80 deg, expected at most 78 deg with legs");
  EXPECT_EQ(leg_faults(bit, sound_legs())[0].cone, 1U);
}

TEST(LegFaults, name_legs_in_one_place) {
  Bit bit = toothed_bit(0.0, 0.0);
  const auto at = [&](double azimuth) {
    std::vector<ConeLayout> cones{bit.cones[0].layout, bit.cones[0].layout};
    cones[1].azimuth = azimuth;
    return leg_faults(cone_bit("any", cones, 0.1, bit.shank), sound_legs());
  };
  EXPECT_TRUE(at(120 * degree).empty());
  const std::vector<LegFault> faults = at(40 * degree);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults[0].key, "width");
  EXPECT_EQ(faults[0].found.find("50 mm, with which the azimuths of leg-1 and leg-2 overlap by "),
            0U)
      << faults[0].found;
  EXPECT_EQ(faults[0].expected, "a slot between all 2 legs");
}

}  // namespace
}  // namespace tdbd::bit::legs_test
