#include "rock/section/section.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/random.hpp"
#include "mesh/measures.hpp"
#include "reference/rock/section_by_columns.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::section_test {

constexpr double pi = std::numbers::pi;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Rock rock_of(const mesh::TriangleMesh& m, double cell) {
  return make_rock(mesh::make_surface(m), cell, mesh::bounding_box(m));
}

Section section_of(const Rock& rock, const FaceOutline& face, const Pose& X_WB,
                   const rotation::Twist& twist, const SectionPlace& place) {
  SectionWork work;
  return section(rock, section_face(face), X_WB, twist, place, work);
}

/// A disc's face at the origin that moves along +x and leans over the rock ahead by `rake`.
FaceOutline face_along_x(double radius, int points, double rake) {
  FaceOutline face;
  face.X_BF.R.col(0) = Vec3(std::cos(rake), 0.0, std::sin(rake));
  face.X_BF.R.col(2) = Vec3(std::sin(rake), 0.0, -std::cos(rake));
  face.X_BF.R.col(1) = face.X_BF.R.col(2).cross(face.X_BF.R.col(0));
  for (int k = 0; k < points; ++k) {
    const double a = 2.0 * pi * k / points;
    face.rim_F.emplace_back(radius * std::sin(a), -radius * std::cos(a));
  }
  return face;
}

double segment_area(double radius, double height) {
  const double half = std::acos(1.0 - height / radius);
  return radius * radius * (half - std::sin(half) * std::cos(half));
}

constexpr double radius = 0.3, deepest = 0.1, rake = 0.3;
const rotation::Twist along_x{Vec3::Zero(), Vec3(2.0, 0.0, 0.0)};

/// A disc of depth 0.1 below flat rock, moving straight.
Section of_flat_rock(int points) {
  const Rock rock = rock_of(battery::flat_rock(1.0, 0.0, 20), 0.2);
  const Pose X_WB{Mat3::Identity(), Vec3(-0.07, 0.013, deepest - radius * std::cos(rake))};
  return section_of(rock, face_along_x(radius, points, rake), X_WB, along_x, {0.12, 0.15});
}

TEST(Section, of_flat_rock_on_a_straight_path_is_a_circular_segment) {
  const double height = deepest / std::cos(rake);  // along the leaning face
  std::vector<double> spacings, errors, edge_errors;
  for (int points = 64; points <= 1024; points *= 2) {
    const Section s = of_flat_rock(points);
    spacings.push_back(1.0 / points);
    errors.push_back(std::abs(s.area / segment_area(radius, height) - 1.0));
    const double arc = 2.0 * radius * std::acos(1.0 - height / radius);
    edge_errors.push_back(std::abs(s.engaged_edge / arc - 1.0));
  }
  const double order = std::log2(errors.front() / errors.back()) / 4.0;
  fmt::print("area: order {:.3f}, last error {:.2e}; edge: last error {:.2e}\n", order,
             errors.back(), edge_errors.back());
  EXPECT_NEAR(order, 2.0, 0.01);          // a polygon's area in its circle
  EXPECT_LT(errors.back(), 2e-5);         // of the area
  EXPECT_LT(edge_errors.back(), 1.8e-5);  // of the arc
}

/// Distance ahead over the lead, of an upright face whose path goes down by `angle`: the area is that of
/// the segment at the depth to which the face has been carried.
double share_of_lead(double angle) {
  constexpr double lead = 0.05, depth = 0.05;
  const Rock rock = rock_of(battery::flat_rock(1.0, 0.0, 20), 0.2);
  const rotation::Twist path{Vec3::Zero(), Vec3(std::cos(angle), 0.0, std::sin(angle))};
  const Pose X_WB{Mat3::Identity(), Vec3(-0.07, 0.013, depth - radius)};
  const double area =
      section_of(rock, face_along_x(radius, 4096, 0.0), X_WB, path, {lead, 0.3}).area;
  double lo = 0.0, hi = radius;  // m, depth of a segment of this area
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lo + hi);
    (segment_area(radius, middle) < area ? lo : hi) = middle;
  }
  return (lo - depth) / std::tan(angle) / lead;
}

/// The whole lead up to 37 degrees, 0.7 of it from 60 degrees, and between them a cubic.
TEST(Section, of_a_face_that_plunges_is_measured_nearer) {
  constexpr double bound = 3e-5;  // of a polygon of 4096 corners
  EXPECT_NEAR(share_of_lead(0.2), 1.0, bound);
  EXPECT_NEAR(share_of_lead(std::acos(0.81)), 1.0, bound);
  EXPECT_NEAR(share_of_lead(std::acos(0.65)), 0.85, bound);
  EXPECT_NEAR(share_of_lead(std::acos(0.49)), 0.7, bound);
  EXPECT_NEAR(share_of_lead(1.2), 0.7, bound);
}

TEST(Section, of_flat_rock_has_the_centroid_and_the_angles_of_the_segment) {
  const Section s = of_flat_rock(2048);
  const double height = deepest / std::cos(rake), half = std::acos(1.0 - height / radius);
  const double below_centre =
      2.0 * std::pow(radius * std::sin(half), 3) / (3.0 * segment_area(radius, height));
  const Vec3 expected = below_centre * Vec3(-std::sin(rake), 0.0, std::cos(rake));
  EXPECT_LT((s.centroid_B - expected).norm(), 9e-7 * radius);
  EXPECT_NEAR(s.angle_of_attack, 0.5 * pi - rake, 1e-12);
  EXPECT_NEAR(s.volume_rate, s.area * 2.0 * std::cos(rake), 1e-12 * s.volume_rate);
}

TEST(Section, is_nothing_above_the_rock_and_behind_its_edge) {
  const Rock rock = rock_of(battery::flat_rock(1.0, 0.0, 20), 0.2);
  const FaceOutline face = face_along_x(radius, 32, rake);
  for (const Vec3& p : {Vec3(0, 0, -0.5), Vec3(-3, 0, 0), Vec3(0, 0, -0.301)}) {
    const Section s = section_of(rock, face, {Mat3::Identity(), p}, along_x, {0.12, 0.15});
    EXPECT_EQ(s.area, 0.0);
    EXPECT_EQ(s.engaged_edge, 0.0);
    EXPECT_EQ(s.volume_rate, 0.0);
  }
}

/// A face that goes backwards cuts nothing.
TEST(Section, is_nothing_for_a_face_that_goes_backwards) {
  const Rock rock = rock_of(battery::flat_rock(1.0, 0.0, 20), 0.2);
  const Section s = section_of(rock, face_along_x(radius, 32, rake), {},
                               {Vec3::Zero(), Vec3(-1.0, 0.0, 0.0)}, {0.12, 0.15});
  EXPECT_EQ(s.area, 0.0);
}

/// Any face across or above a bumpy sheet on a straight path; its upper end is in the open.
struct AnySection {
  mesh::TriangleMesh rock_W;
  FaceOutline face;
  Pose X_WB;
  rotation::Twist twist;
};

AnySection any_section() {
  AnySection a;
  a.rock_W = battery::bumpy_rock(1.0, *battery::integer(8, 30), *battery::number(0.0, 0.3),
                                 *rc::gen::arbitrary<std::uint64_t>());
  a.face = face_along_x(*battery::number(0.15, 0.3), *battery::integer(3, 40),
                        *battery::number(-0.5, 0.5));
  const double turned = *battery::number(-3.0, 3.0);
  a.X_WB.R << std::cos(turned), -std::sin(turned), 0.0, std::sin(turned), std::cos(turned), 0.0,
      0.0, 0.0, 1.0;
  a.X_WB.p = *battery::point(0.2);
  a.X_WB.p.z() = -std::abs(a.X_WB.p.z());
  a.twist.linear_B = Vec3(1.0, *battery::number(-0.3, 0.3), *battery::number(-0.1, 0.1));
  return a;
}

double longest_edge(const mesh::TriangleMesh& m) {
  double longest = 0.0;
  for (const mesh::Triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, (m.positions[static_cast<std::size_t>(t[i])] -
                                   m.positions[static_cast<std::size_t>(t[(i + 1) % 3])])
                                      .norm());
  return longest;
}

/// The twin cuts columns of the carried face by every triangle of the rock.
RC_GTEST_PROP(Section, is_what_columns_of_the_carried_face_find_in_the_rock, ()) {
  const AnySection a = any_section();
  const double lead = *battery::number(0.0, 0.2);
  const Section s =
      section_of(rock_of(a.rock_W, 0.2), a.face, a.X_WB, a.twist, {lead, longest_edge(a.rock_W)});
  const double forward = a.face.X_BF.R.col(0).dot(a.twist.linear_B);
  Pose X_WF = a.X_WB * a.face.X_BF;
  X_WF.p += a.X_WB.R * a.twist.linear_B * (lead / forward);
  const double width = 2.0 * a.face.rim_F[0].norm();
  const auto columns = reference::section_by_columns(a.rock_W, X_WF, a.face.rim_F, 2000);
  // wide: other seeds see half of it
  RC_ASSERT(std::abs(s.area - columns.area) <= 1e-5 * width * width / 4.0);
  if (columns.area < 1e-3 * width * width) return;
  const Vec2 centroid_F = columns.moment / columns.area;
  const Vec3 centroid_B = a.face.X_BF * Vec3(0.0, centroid_F.x(), centroid_F.y());
  RC_ASSERT((s.centroid_B - centroid_B).norm() <= 6e-7 * width * width * width / columns.area);
}

/// The part of the outline that goes forward, by Sutherland and Hodgman's clipping.
std::vector<Vec2> forward_part(const AnySection& a) {
  const std::vector<Vec2>& rim = a.face.rim_F;
  const auto speed = [&](const Vec2& x_F) {
    const Vec3 x_B = a.face.X_BF * Vec3(0.0, x_F.x(), x_F.y());
    return a.face.X_BF.R.col(0).dot(rotation::velocity_B(a.twist, x_B));
  };
  std::vector<Vec2> part;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec2 &p = rim[i], &q = rim[(i + 1) % rim.size()];
    const double v = speed(p), w = speed(q);
    if (v >= 0.0) part.push_back(p);
    if (v * w < 0.0) part.push_back(p + v / (v - w) * (q - p));
  }
  return part;
}

/// A face that turns about an axis within it goes backwards on one side. With next to no lead its
/// section lies in its own plane, and the twin knows it.
RC_GTEST_PROP(Section, of_a_turning_face_is_that_of_its_forward_part, ()) {
  constexpr double hardly = 1e-7;  // m of lead, and rad of turn
  AnySection a = any_section();
  const double side = *rc::gen::element(-1.0, 1.0);
  a.twist = {Vec3(0.0, 0.0, side * *battery::number(4.0, 20.0)), Vec3::UnitX()};
  const std::vector<Vec2> forward = forward_part(a);
  RC_PRE(forward.size() > 2U);
  const Section s = section_of(rock_of(a.rock_W, 0.2), a.face, a.X_WB, a.twist,
                               {hardly, longest_edge(a.rock_W), -1, hardly});
  const auto columns = reference::section_by_columns(a.rock_W, a.X_WB * a.face.X_BF, forward, 2000);
  const double radius_of_face = a.face.rim_F[0].norm();
  // wide: other seeds see half of it
  RC_ASSERT(std::abs(s.area - columns.area) <= 2e-6 * radius_of_face * radius_of_face);
}

/// Cells as large as the rock offer every triangle; small ones must find all that count. The turn
/// and the axis within the face make strips.
RC_GTEST_PROP(Section, from_the_grid_is_that_from_all_triangles, ()) {
  AnySection a = any_section();
  a.twist.angular_B = Vec3(0.0, 0.0, *battery::number(-6.0, 6.0));
  const SectionPlace place{*battery::number(0.0, 0.2), longest_edge(a.rock_W)};
  const Section near = section_of(rock_of(a.rock_W, 0.07), a.face, a.X_WB, a.twist, place);
  const Section all = section_of(rock_of(a.rock_W, 100.0), a.face, a.X_WB, a.twist, place);
  RC_ASSERT(near.area == all.area);
  RC_ASSERT(near.engaged_edge == all.engaged_edge);
  RC_ASSERT((near.centroid_B.array() == all.centroid_B.array()).all());
  RC_ASSERT(near.angle_of_attack == all.angle_of_attack);
}

/// A list of near vertices replaces the index, also where its positions are rounded.
RC_GTEST_PROP(Section, from_a_list_of_near_vertices_is_that_from_the_grid, ()) {
  const AnySection a = any_section();
  Rock rock = rock_of(a.rock_W, 0.07);
  SectionPlace place{*battery::number(0.0, 0.2), longest_edge(a.rock_W)};
  const Section from_grid = section_of(rock, a.face, a.X_WB, a.twist, place);
  Region all{mesh::bounding_box(a.rock_W), {}};
  for (int k = 0; k < 3; ++k)
    all.slabs[at(k)] = {Vec3::Unit(k), all.box.lo[k] - 9.0, all.box.hi[k] + 9.0};
  rock.near_lists.resize(1);
  update_near_list(rock.grid, {all.box, {}, {}, all}, {}, rock.near_lists[0]);
  RC_ASSERT(covers(rock.near_lists[0], rock.grid, all));
  place.near_list = 0;
  const Section from_list = section_of(rock, a.face, a.X_WB, a.twist, place);
  RC_ASSERT(from_list.area == from_grid.area);
  RC_ASSERT(from_list.engaged_edge == from_grid.engaged_edge);
  RC_ASSERT((from_list.centroid_B.array() == from_grid.centroid_B.array()).all());
}

/// Sums are whole numbers, so that neither order nor numbering has a part in them.
RC_GTEST_PROP(Section, has_the_same_bits_however_the_rock_is_numbered, ()) {
  const AnySection a = any_section();
  const mesh::TriangleMesh& m = a.rock_W;
  Random random{*rc::gen::arbitrary<std::uint64_t>()};
  const auto shuffled = [&](std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = count; i-- > 1;) std::swap(order[i], order[random.next() % (i + 1)]);
    return order;
  };
  const std::vector<int> number = shuffled(m.positions.size());
  mesh::TriangleMesh other;
  other.positions.resize(m.positions.size());
  for (std::size_t i = 0; i < number.size(); ++i) other.positions[at(number[i])] = m.positions[i];
  for (const int t : shuffled(m.triangles.size())) {
    const mesh::Triangle& c = m.triangles[at(t)];
    other.triangles.push_back({number[at(c[1])], number[at(c[2])], number[at(c[0])]});
  }
  const SectionPlace place{0.1, longest_edge(m)};
  const Section s = section_of(rock_of(m, 0.1), a.face, a.X_WB, a.twist, place),
                t = section_of(rock_of(other, 0.1), a.face, a.X_WB, a.twist, place);
  RC_ASSERT(s.area == t.area);
  RC_ASSERT(s.engaged_edge == t.engaged_edge);
  RC_ASSERT((s.centroid_B.array() == t.centroid_B.array()).all());
}

/// From vertices near the plane the outline is followed over edges that are far longer.
RC_GTEST_PROP(Section, follows_the_outline_past_long_edges, ()) {
  AnySection a = any_section();
  for (Vec3& x_W : a.rock_W.positions) x_W.z() *= 0.2;  // hills too flat for islands in the plane
  const double whole = longest_edge(a.rock_W), lead = *battery::number(0.0, 0.2);
  const Rock rock = rock_of(a.rock_W, 0.2);
  const Section far = section_of(rock, a.face, a.X_WB, a.twist, {lead, whole});
  const Section near = section_of(rock, a.face, a.X_WB, a.twist, {lead, 0.45 * whole});
  if (near.sight == OutlineStatus::none) return;
  RC_ASSERT(near.area == far.area);
  RC_ASSERT(near.engaged_edge == far.engaged_edge);
}

/// Rock and bit turned together about z give the section of the unturned ones.
RC_GTEST_PROP(Section, turns_with_rock_and_bit, ()) {
  AnySection a = any_section();
  a.twist.angular_B = *battery::point(2.0);
  const SectionPlace place{*battery::number(0.0, 0.2), longest_edge(a.rock_W)};
  const Section s = section_of(rock_of(a.rock_W, 0.1), a.face, a.X_WB, a.twist, place);
  const Pose turn = rotation::carried({Vec3(0, 0, *battery::number(-3.0, 3.0)), Vec3::Zero()}, 1.0);
  for (Vec3& x_W : a.rock_W.positions) x_W = turn * x_W;
  const Section t = section_of(rock_of(a.rock_W, 0.1), a.face, turn * a.X_WB, a.twist, place);
  RC_ASSERT(std::abs(s.area - t.area) <= 1e-12);  // of 0.1 m2
  RC_ASSERT(std::abs(s.engaged_edge - t.engaged_edge) <= 1e-12);
  RC_ASSERT(std::abs(s.volume_rate - t.volume_rate) <= 1e-12);
}

/// A section knows no step: twice the speed on the same path sweeps twice the volume.
RC_GTEST_PROP(Section, depends_on_the_path_and_not_on_the_speed_along_it, ()) {
  AnySection a = any_section();
  a.twist.angular_B = *battery::point(2.0);
  const SectionPlace place{0.1, longest_edge(a.rock_W)};
  const Rock rock = rock_of(a.rock_W, 0.1);
  const Section s = section_of(rock, a.face, a.X_WB, a.twist, place);
  const rotation::Twist twice{2.0 * a.twist.angular_B, 2.0 * a.twist.linear_B};
  const Section t = section_of(rock, a.face, a.X_WB, twice, place);
  RC_ASSERT(std::abs(s.area - t.area) <= 1e-12);  // of 0.1 m2
  RC_ASSERT(std::abs(2.0 * s.volume_rate - t.volume_rate) <= 1e-12);
  RC_ASSERT(std::abs(s.angle_of_attack - t.angle_of_attack) <= 1e-15);
}

TEST(Section, reports_rock_that_reaches_over_the_face_or_is_out_of_sight) {
  const Rock rock = rock_of(battery::flat_rock(1.0, 0.0, 20), 0.2);
  const FaceOutline face = face_along_x(radius, 32, rake);
  const auto sight_at = [&](double z) {
    return section_of(rock, face, {Mat3::Identity(), Vec3(0, 0, z)}, along_x, {0.12, 0.15}).sight;
  };
  EXPECT_EQ(sight_at(-0.25), OutlineStatus::clear);
  EXPECT_EQ(sight_at(-0.9), OutlineStatus::none);
  EXPECT_EQ(sight_at(0.4), OutlineStatus::over_the_top);
  EXPECT_EQ(sight_at(0.9), OutlineStatus::none);
}

/// The outline may reach a quarter of the reach over the face, which is doubled for rock that the
/// lower half of the face does not meet.
TEST(Section, counts_a_quarter_of_the_reach_over_the_face_as_its_own) {
  const Rock rock = rock_of(battery::flat_rock(1.0, 0.0, 20), 0.2);
  const FaceOutline face = face_along_x(radius, 32, rake);
  const double top = radius + 0.25 * (2.0 * 0.15);
  const auto sight_at = [&](double height_F) {
    const Vec3 p_W(0.0, 0.0, height_F * std::cos(rake));
    return section_of(rock, face, {Mat3::Identity(), p_W}, along_x, {0.12, 0.15}).sight;
  };
  EXPECT_EQ(sight_at(0.99 * top), OutlineStatus::clear);
  EXPECT_EQ(sight_at(1.01 * top), OutlineStatus::over_the_top);
}

/// Of a ridge that runs along the path only its top is over the face: one end of two segments.
TEST(Section, reports_a_ridge_that_reaches_over_the_face) {
  mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, 20);
  for (Vec3& x : m.positions) x.z() = 3.0 * std::abs(x.y());
  const Rock rock = rock_of(m, 0.2);
  const auto sight_at = [&](double height_F) {
    const Vec3 p_W(-0.1, 0.0, height_F * std::cos(rake));
    return section_of(rock, face_along_x(radius, 32, rake), {Mat3::Identity(), p_W}, along_x,
                      {0.12, 0.15})
        .sight;
  };
  constexpr double top = radius + 0.25 * 0.15;
  EXPECT_EQ(sight_at(0.99 * top), OutlineStatus::clear);
  EXPECT_EQ(sight_at(1.01 * top), OutlineStatus::over_the_top);
}

}  // namespace tdbd::rock::section_test
