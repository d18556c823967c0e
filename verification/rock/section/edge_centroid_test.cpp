#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/observed_order.hpp"
#include "mesh/measures.hpp"
#include "rock/section/section.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

/// The centroid of the engaged edge, Section::edge_centroid_B, in rock whose surface is a plane
/// along the path: what is engaged of the outline is then known in closed form.
namespace tdbd::rock::edge_centroid_test {
namespace {

/// Forwards along x, upright, at the origin; y of F is -y of the world, z of F is up.
Pose upright() {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = -Vec3::UnitY();
  X.R.col(2) = -Vec3::UnitZ();
  return X;
}

/// Rock below the line z_F = height + slope y_F.
Rock rock_below(double height, double slope) {
  mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, 20);
  for (Vec3& x_W : m.positions) x_W.z() = -height + slope * x_W.y();
  return make_rock(mesh::make_surface(m), 0.2, mesh::bounding_box(m));
}

Section section_of(const Rock& rock, const ConvexPolygon& rim_F) {
  SectionWork work;
  return section(rock, section_face({upright(), rim_F}), {}, {Vec3::Zero(), Vec3::UnitX()},
                 {0.12, 0.15}, work);
}

/// Length, and length times place.
struct Edge {
  double length = 0.0;
  Vec2 moment_F = Vec2::Zero();
};

/// The parts of an outline's sides below a line, side by side.
Edge edge_below(const ConvexPolygon& rim_F, double height, double slope) {
  Edge sum;
  const auto depth = [&](const Vec2& x) { return height + slope * x.x() - x.y(); };
  for (std::size_t i = 0; i < rim_F.size(); ++i) {
    Vec2 p = rim_F[i], q = rim_F[(i + 1) % rim_F.size()];
    const double from = depth(p), to = depth(q);
    if (from <= 0.0 && to <= 0.0) continue;
    const Vec2 crossing = p + from / (from - to) * (q - p);
    if (from < 0.0) p = crossing;
    if (to < 0.0) q = crossing;
    sum.length += (q - p).norm();
    sum.moment_F += (q - p).norm() * 0.5 * (p + q);
  }
  return sum;
}

ConvexPolygon circle(double radius, int points, double first) {
  ConvexPolygon rim_F;
  for (int k = 0; k < points; ++k) {
    const double a = 2.0 * std::numbers::pi * (k + first) / points;
    rim_F.emplace_back(radius * std::sin(a), -radius * std::cos(a));
  }
  return rim_F;
}

}  // namespace

/// Any number of sides, long ones and upright ones among them, of which any part is engaged.
RC_GTEST_PROP(EdgeCentroid, is_that_of_the_parts_of_the_sides_in_rock, ()) {
  const double left = *battery::number(-0.3, 0.0), right = left + *battery::number(0.1, 0.3);
  const ConvexPolygon box{{left, -0.2},
                          {right, *battery::number(-0.25, -0.1)},
                          {right, 0.2},
                          {left, *battery::number(0.1, 0.3)}};
  const ConvexPolygon rim_F =
      *rc::gen::element(box, circle(0.25, *battery::integer(3, 20), *battery::number(0.0, 1.0)));
  const double height = *battery::number(-0.15, 0.15), slope = *battery::number(-0.3, 0.3);
  const Edge expected = edge_below(rim_F, height, slope);
  RC_PRE(expected.length > 0.05);
  const Section s = section_of(rock_below(height, slope), rim_F);
  const Vec2 centroid_F = expected.moment_F / expected.length;
  RC_ASSERT(std::abs(s.engaged_edge - expected.length) <= 1e-12);
  RC_ASSERT((s.edge_centroid_B - upright() * Vec3(0.0, centroid_F.x(), centroid_F.y())).norm() <=
            1e-12);
}

/// A trapezium of which one side is upright and the other leans, and its mirror image; the rock
/// comes up to 0.1 above its lower side, to 0.4 of the height of the others.
TEST(EdgeCentroid, of_a_trapezium_has_partly_engaged_sides_at_the_middle_of_what_is_engaged) {
  const double upright_side = 0.1, lower = 0.15, leaning = std::hypot(0.028, 0.1),
               whole = upright_side + lower + leaning;
  const Vec2 sum_F =
      upright_side * Vec2(-0.1, 0.0) + lower * Vec2(-0.025, -0.05) + leaning * Vec2(0.064, 0.0);
  for (const double side : {1.0, -1.0}) {
    ConvexPolygon rim_F{{-0.1, -0.05}, {0.05, -0.05}, {0.12, 0.2}, {-0.1, 0.2}};
    for (Vec2& x_F : rim_F) x_F.x() *= side;
    if (side < 0.0) std::ranges::reverse(rim_F);
    const Section s = section_of(rock_below(0.05, 0.0), rim_F);
    EXPECT_NEAR(s.engaged_edge, whole, 1e-12);
    EXPECT_LT(
        (s.edge_centroid_B - upright() * Vec3(0.0, side * sum_F.x() / whole, sum_F.y() / whole))
            .norm(),
        1e-12);
  }
}

/// Polygons in a circle, turned so that every share of their last sides is engaged. An outline's
/// error is of order 2 in its sides; so must be that of its edge's centroid, however much of the
/// last sides is engaged. Mean over the turns.
TEST(EdgeCentroid, of_a_polygon_comes_to_that_of_the_arc_with_order_2) {
  constexpr double radius = 0.3, height = -0.2;
  const double half = std::acos(-height / radius);
  const Vec3 arc_B = upright() * Vec3(0.0, 0.0, -radius * std::sin(half) / half);
  const Rock rock = rock_below(height, 0.0);
  std::vector<double> sides, errors;
  for (int points = 16; points <= 256; points *= 2) {
    double mean = 0.0;
    constexpr int turns = 20;
    for (int k = 0; k < turns; ++k)
      mean += (section_of(rock, circle(radius, points, (k + 0.5) / turns)).edge_centroid_B - arc_B)
                  .norm() /
              (turns * radius);
    sides.push_back(1.0 / points);
    errors.push_back(mean);
    fmt::print("{:4d} sides: error {:.2e} of the radius\n", points, mean);
  }
  const double order = least_squares_order(sides, errors);
  fmt::print("order {:.2f}\n", order);
  EXPECT_NEAR(order, 2.0, 0.1);
  EXPECT_LT(errors.back(), 1.1e-4);
}

}  // namespace tdbd::rock::edge_centroid_test
