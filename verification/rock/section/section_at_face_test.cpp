#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "bit/pdc/pdc_bit.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/observed_order.hpp"
#include "core/types.hpp"
#include "reference/bit/radial_plane_engagement.hpp"
#include "rock/cut/cut_rock.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/section/breakout.hpp"
#include "rock/section/section.hpp"
#include "rock/start/borehole.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

/// The section of the rock at the face while the bit is deeper than the cut of the rock ahead of
/// it: a disc that turns about an axis beside it and goes down into flat rock.
namespace tdbd::rock::section_at_face_test {

constexpr double radius = 0.3, deepest = 0.1, rake = 0.3;        // m, m, rad
constexpr double from_axis = 0.8, turning = 1.3, sinking = 0.3;  // m, rad/s, m/s
const rotation::Twist screw{Vec3(0.0, 0.0, turning), Vec3(0.0, 0.0, sinking)};

/// The frame of a disc that looks along x and leans over the rock ahead.
Pose disc_on_bit() {
  Pose X_BF;
  X_BF.R.col(0) = Vec3(std::cos(rake), 0.0, std::sin(rake));
  X_BF.R.col(2) = Vec3(std::sin(rake), 0.0, -std::cos(rake));
  X_BF.R.col(1) = X_BF.R.col(2).cross(X_BF.R.col(0));
  X_BF.p = Vec3(0.0, -from_axis, 0.0);
  return X_BF;
}

SectionFace disc() {
  constexpr int points = 8192;
  FaceOutline face;
  face.X_BF = disc_on_bit();
  for (int k = 0; k < points; ++k) {
    const double a = 2.0 * std::numbers::pi * k / points;
    face.rim_F.emplace_back(radius * std::sin(a), -radius * std::cos(a));
  }
  return section_face(std::move(face));
}

/// A section as numbers, none of which is small.
using Numbers = std::array<double, 8>;
constexpr std::array<const char*, 8> names{"area",        "centroid y", "centroid z",  "edge",
                                           "edge middle", "attack",     "volume rate", "edge x"};

Numbers numbers_of(const Section& s) {
  const Pose X_FB = inverse(disc_on_bit());
  const Vec3 c_F = X_FB * s.centroid_B, e_F = X_FB * s.edge_centroid_B;
  return {s.area,  1.0 + c_F.y(),     c_F.z(),       s.engaged_edge,
          e_F.z(), s.angle_of_attack, s.volume_rate, 1.0 + s.edge_centroid_B.x()};
}

/// The circular segment that is in the rock, by its closed forms; the angle of attack by Simpson's rule.
Numbers at_the_face() {
  const double height = deepest / std::cos(rake), half = std::acos(1.0 - height / radius);
  const double area = radius * radius * (half - std::sin(half) * std::cos(half));
  const double deep = 2.0 / 3.0 * radius * radius * radius * std::pow(std::sin(half), 3) / area;
  const double edge = 2.0 * radius * half, middle = radius * std::sin(half) / half;
  const Pose X_BF = disc_on_bit();
  const auto velocity = [&](double y, double z) {
    const Vec3 x_B = X_BF * Vec3(0.0, y, z);
    return Vec3(screw.linear_B + screw.angular_B.cross(x_B));
  };
  constexpr int pieces = 2000;
  double attack = 0.0;
  for (int i = 0; i <= pieces; ++i) {
    const double a = half * (2.0 * i / pieces - 1.0);
    const Vec3 v = velocity(radius * std::sin(a), -radius * std::cos(a));
    const double weight = i == 0 || i == pieces ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    attack += weight / (3.0 * pieces) * std::asin(X_BF.R.col(0).dot(v) / v.norm());
  }
  const double rate = area * X_BF.R.col(0).dot(velocity(0.0, -deep));
  return {area,    1.0,    -deep, edge,
          -middle, attack, rate,  1.0 + (X_BF * Vec3(0.0, 0.0, -middle)).x()};
}

/// Errors of every number, relative, at falling leads.
std::array<std::vector<double>, 8> errors_at(const std::vector<double>& leads,
                                             SectionAtFace at_face) {
  const mesh::TriangleMesh flat = battery::flat_rock(2.0, 0.0, 20);
  const Rock rock = make_rock(mesh::make_surface(flat), 0.2, mesh::bounding_box(flat));
  const Pose X_WB{Mat3::Identity(), Vec3(-0.07, from_axis, deepest - radius * std::cos(rake))};
  const Numbers exact = at_the_face();
  std::array<std::vector<double>, 8> errors;
  SectionWork work;
  for (const double lead : leads) {
    const Numbers found = numbers_of(section(
        rock, disc(), X_WB, screw, {.lead = lead, .reach = 0.15, .at_face = at_face}, work));
    for (std::size_t i = 0; i < exact.size(); ++i)
      errors[i].push_back(std::abs(found[i] / exact[i] - 1.0));
  }
  return errors;
}

TEST(SectionAtFace, is_of_second_order_in_the_lead_for_every_number) {
  const std::vector<double> leads{0.02, 0.0141, 0.01, 0.00707, 0.005, 0.00354};
  const auto ahead = errors_at(leads, SectionAtFace::as_ahead);
  const auto extrapolated = errors_at(leads, SectionAtFace::extrapolated);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double largest = *std::ranges::max_element(ahead[i]);
    constexpr double polygon = 1e-5;  // of a circle, far below the errors of the rest
    if (largest < polygon) {
      fmt::print("{}: no error\n", names[i]);
      EXPECT_LT(*std::ranges::max_element(extrapolated[i]), polygon) << names[i];
      continue;
    }
    const double first = least_squares_order(leads, ahead[i]),
                 second = least_squares_order(leads, extrapolated[i]);
    fmt::print("{}: order {:.2f}, error {:.1e}; extrapolated: order {:.2f}, error {:.1e}\n",
               names[i], first, ahead[i].back(), second, extrapolated[i].back());
    EXPECT_NEAR(first, 1.0, 0.2) << names[i];
    EXPECT_NEAR(second, 2.0, 0.2) << names[i];
  }
}

/// A step in the rock ahead makes the straight line too steep: never less than nothing.
TEST(SectionAtFace, is_nothing_where_the_line_falls_below_nothing) {
  mesh::TriangleMesh ramp = battery::flat_rock(2.0, 0.0, 40);
  for (Vec3& x : ramp.positions) x.z() = -0.9 * std::max(0.0, x.x());
  const Rock rock = make_rock(mesh::make_surface(ramp), 0.2, mesh::bounding_box(ramp));
  const Pose X_WB{Mat3::Identity(), Vec3(0.05, 0.013, -0.002 - radius * std::cos(rake))};
  FaceOutline face = disc().outline;
  face.X_BF.p.setZero();
  const rotation::Twist along_x{Vec3::Zero(), Vec3(1.0, 0.0, 0.0)};
  SectionWork work;
  const SectionPlace ahead{.lead = 0.1, .reach = 0.15};
  SectionPlace at_face = ahead;
  at_face.at_face = SectionAtFace::extrapolated;
  EXPECT_GT(section(rock, section_face(face), X_WB, along_x, ahead, work).area, 0.0);
  const Section s = section(rock, section_face(face), X_WB, along_x, at_face, work);
  EXPECT_EQ(s.area, 0.0);
  EXPECT_EQ(s.engaged_edge, 0.0);
  EXPECT_EQ(s.sight, OutlineStatus::clear);
}

constexpr double turn = 2.0 * std::numbers::pi, mm = 1e-3;
constexpr double advance = 4.0 * mm;  // a revolution, which takes a second
constexpr long steps = 180;           // a revolution

/// Four sharp thin discs, each a quarter of a turn behind the last; the outer ones lean outwards,
/// so that what is behind their edges clears the wall and faces take all the rock.
bit::Bit small_bit() {
  constexpr std::array<double, 4> heights{0.0, 0.0, 0.5 * mm, 3.0 * mm};
  constexpr std::array<double, 4> profile_angles{0.0, 0.0, 0.3, 1.0};
  std::vector<bit::Cutter> cutters(4);
  for (std::size_t i = 0; i < 4; ++i) {
    bit::Cutter& c = cutters[i];
    c.id = static_cast<int>(i) + 1;
    c.length = 1.0 * mm;
    c.table_thickness = 0.5 * mm;
    c.tip_height = heights[i];
    c.profile_angle = profile_angles[i];
    c.diameter = 13.0 * mm;
    c.tip_radius = (4.0 + 4.0 * static_cast<double>(i)) * mm;
    c.azimuth = 0.25 * turn * static_cast<double>(i);
    c.back_rake = 0.15;
  }
  return bit::pdc_bit("small", cutters, {});
}

Pose pose_after(long step) {
  const double time = static_cast<double>(step) / steps;
  return rotation::carried({Vec3(0, 0, turn), Vec3(0, 0, advance)}, time);
}

Rock conforming_rock(const bit::Bit& bit, double edge_length) {
  std::vector<MeridianPoint> curve;
  for (const bit::ProfilePoint& p : bit::exposure_profile(bit.parts, 0.25 * edge_length))
    curve.push_back({p.r, p.z});
  const mesh::TriangleMesh m = borehole(with_wall(curve, 8.0 * mm), edge_length);
  mesh::Box reach = mesh::bounding_box(m);
  reach.hi.z() += 4.0 * advance;
  return make_rock(mesh::make_surface(m), 2.0 * edge_length, reach);
}

/// Mean volumes that the sections sweep in the third revolution, m3 a revolution.
std::vector<double> swept_by_sections(const bit::Bit& bit, double edge_length) {
  Rock rock = conforming_rock(bit, edge_length);
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const rotation::Twist twist{Vec3(0, 0, turn), Vec3(0, 0, advance)};
  CutWorkspace cut_work;
  CutReport cut;
  MaintenanceWorkspace maintain_work;
  MaintenanceReport maintained;
  SectionWork section_work;
  std::vector<SectionFace> faces;
  faces.reserve(bit.cutters.size());
  for (std::size_t c = 0; c < bit.cutters.size(); ++c)
    faces.push_back(section_face(face_outline(bit.cutters[c], static_cast<int>(c), bit.parts)));
  std::vector<double> volumes(bit.cutters.size(), 0.0);
  for (long i = 0; i < 3 * steps; ++i) {
    cut_rock(rock, cutting, pose_after(i), pose_after(i + 1), cut_work, cut);
    if (i % 5 == 4) maintain(rock, bare_limits_for(edge_length), maintain_work, maintained);
    if (i < 2 * steps) continue;
    for (std::size_t c = 0; c < volumes.size(); ++c)
      volumes[c] += section(rock, faces[c], pose_after(i + 1), twist,
                            {1.2 * edge_length, 1.0 * edge_length}, section_work)
                        .volume_rate /
                    steps;
  }
  return volumes;
}

/// The first and the last cutter are left out. Beside the axis the side of the disc behind the face
/// takes a part (section_noise_test). On the wall cusps should stay between
/// the passes of the last one, which columns of radii count as removed: its section is 3 % lower.
TEST(SteadySection, comes_to_what_the_radial_plane_gives_with_the_edge_length) {
  const bit::Bit bit = small_bit();
  const auto expected = reference::radial_plane_engagement(bit, advance, 0.02 * mm);
  const std::vector<double> edges{2.4 * mm, 1.7 * mm, 1.2 * mm, 0.85 * mm, 0.6 * mm};
  std::vector<double> errors;
  for (const double edge : edges) {
    const std::vector<double> volumes = swept_by_sections(bit, edge);
    double squares = 0.0;
    fmt::print("edges {:.2f} mm:", edge / mm);
    for (std::size_t c = 1; c + 1 < volumes.size(); ++c) {
      const double error = volumes[c] / expected.volume_per_revolution[c] - 1.0;
      fmt::print(" {:+.3f} %", 100.0 * error);
      squares += 0.5 * error * error;
    }
    errors.push_back(std::sqrt(squares));
    fmt::print("; rms {:.3f} %\n", 100.0 * errors.back());
  }
  const double order = least_squares_order(edges, errors);
  fmt::print("order {:.2f}\n", order);
  EXPECT_GE(order, 1.0);
  EXPECT_LT(errors.back(), 0.0026);  // of the volume
}

}  // namespace tdbd::rock::section_at_face_test

namespace tdbd::rock::breakout_test {

double within(double lo, double hi) {
  return lo + (hi - lo) * static_cast<double>(*rc::gen::inRange(0, 1000001)) / 1e6;
}

/// A regular polygon with its lowest corner at (0, 0).
ConvexPolygon round_face(double radius, int corners) {
  ConvexPolygon rim;
  for (int i = 0; i < corners; ++i) {
    const double t = 2.0 * std::numbers::pi * i / corners;
    rim.emplace_back(radius * std::sin(t), radius * (1.0 - std::cos(t)));
  }
  return rim;
}

/// With any rakes, a crack of this slope in the plane of the face has its angle with the normal,
/// seen along the motion.
RC_GTEST_PROP(CrackSlope, is_seen_at_its_angle_along_the_motion, ()) {
  const double back = within(0.0, 0.6), tilt = within(-0.3, 0.3), angle = within(0.2, 1.2);
  Pose X;
  const Vec3 along = Vec3::UnitX(), normal = Vec3::UnitZ();
  const Vec3 z = std::sin(back) * along - std::cos(back) * normal,
             x0 = std::cos(back) * along + std::sin(back) * normal, y0 = z.cross(x0);
  X.R.col(0) = std::cos(tilt) * x0 + std::sin(tilt) * y0;
  X.R.col(1) = std::cos(tilt) * y0 - std::sin(tilt) * x0;
  X.R.col(2) = z;
  for (const FaceSide side : {FaceSide::left, FaceSide::right}) {
    const double slope = crack_slope(X, side, along, normal, angle);
    if (slope <= 0.0) continue;
    const double sign = side == FaceSide::left ? -1.0 : 1.0;
    const Vec3 crack = X.R * Vec3(0.0, sign * slope, 1.0);
    const double up = -crack.dot(normal), sideways = std::abs(crack.y());
    RC_ASSERT(std::abs(std::atan2(sideways, up) - angle) < 1e-12);
  }
}

TEST(CrackSlope, of_a_face_without_rakes_is_the_tangent) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = -Vec3::UnitY();
  X.R.col(2) = -Vec3::UnitZ();
  for (const FaceSide side : {FaceSide::left, FaceSide::right})
    EXPECT_NEAR(crack_slope(X, side, Vec3::UnitX(), Vec3::UnitZ(), 60.0 * degree), std::sqrt(3.0),
                1e-15);
}

/// Where cracks from all points of the edge in rock reach at a height, by many points.
double reach_by_points(const Breakout& b, double end_z, double sign) {
  const ConvexPolygon& edge = sign < 0.0 ? b.left_F : b.right_F;
  const double top = std::min(end_z, edge.back().y()), lowest = edge.front().y();
  const double start = top - b.share * (top - lowest);
  double reach = -INFINITY;
  for (std::size_t i = 0; i + 1 < edge.size(); ++i)
    for (int k = 0; k <= 2000; ++k) {
      const Vec2 x = edge[i] + k / 2000.0 * (edge[i + 1] - edge[i]);
      if (x.y() >= start - 1e-15 && x.y() <= top + 1e-15)
        reach = std::max(reach, sign * x.x() + b.slope * (top - x.y()));
    }
  return reach;
}

RC_GTEST_PROP(CrackStart, is_from_where_a_crack_reaches_farthest, ()) {
  const double radius = 1.0;
  const ConvexPolygon rim = round_face(radius, *rc::gen::inRange(8, 80));
  Breakout b;
  b.left_F = lower_edge(rim, FaceSide::left);
  b.right_F = lower_edge(rim, FaceSide::right);
  b.slope = within(0.1, 5.0);
  b.share = within(0.01, 1.0);
  const double end = within(0.01, 1.5), top = std::min(end, b.right_F.back().y());
  for (const BreakoutPlace place : {BreakoutPlace::left, BreakoutPlace::right}) {
    b.place = place;
    const double sign = place == BreakoutPlace::left ? -1.0 : 1.0;
    const auto start = crack_start(b, end);
    const double by_points = reach_by_points(b, end, sign);
    if (!start) {
      double edge_at_top = 0.0;
      for (std::size_t i = 0; i + 1 < b.right_F.size(); ++i)
        if (const Vec2& p = b.right_F[i], &q = b.right_F[i + 1]; p.y() <= top && top <= q.y())
          edge_at_top = p.x() + (top - p.y()) / std::max(q.y() - p.y(), 1e-300) * (q.x() - p.x());
      RC_ASSERT(by_points <= edge_at_top + 1e-12);
      continue;
    }
    const double reach = sign * start->x() + b.slope * (top - start->y());
    RC_ASSERT(reach >= by_points - 1e-12);
    RC_ASSERT(reach <= by_points + 2e-3 * (1.0 + b.slope));
    RC_ASSERT(start->y() >= top - b.share * top - 1e-12);
    RC_ASSERT(sign * start->x() >= 0.0);
  }
}

/// On a shallow cut by a round face the groove is flatter than a steep crack.
TEST(CrackStart, is_none_where_the_groove_is_flatter_than_the_crack) {
  Breakout b;
  b.right_F = lower_edge(round_face(1.0, 64), FaceSide::right);
  b.place = BreakoutPlace::right;
  b.slope = std::tan(60.0 * degree);
  EXPECT_FALSE(crack_start(b, 0.1));
  EXPECT_TRUE(crack_start(b, 0.2));
}

TEST(LowerEdge, rises_from_the_lowest_point_to_the_widest) {
  const ConvexPolygon rim = round_face(1.0, 8);
  const ConvexPolygon left = lower_edge(rim, FaceSide::left),
                      right = lower_edge(rim, FaceSide::right);
  ASSERT_EQ(left.size(), 3U);
  ASSERT_EQ(right.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(left[i].x(), -right[i].x(), 1e-15);
    EXPECT_NEAR(left[i].y(), right[i].y(), 1e-15);
  }
  EXPECT_NEAR(right.back().x(), 1.0, 1e-15);
}

TEST(RaisedAhead, is_the_share_that_is_left_of_the_deeper_side) {
  Breakout b;
  b.left_F = b.right_F = {{0.0, -3.0}, {1.0, 0.0}};
  b.place = BreakoutPlace::ahead;
  b.share = 0.25;
  EXPECT_FALSE(raised_ahead(b, {}));
  EXPECT_DOUBLE_EQ(*raised_ahead(b, {-2.0, -1.0}), 1.5);
  EXPECT_DOUBLE_EQ(*raised_ahead(b, {std::nullopt, -1.0}), 1.5);
}

}  // namespace tdbd::rock::breakout_test
