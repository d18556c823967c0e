#include "rock/section/engaged_ends.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/measures.hpp"
#include "rock/section/section.hpp"
#include "verification/battery/shapes.hpp"

/// The ends of the engaged edge in rock whose surface is a plane along the path.
namespace tdbd::rock::engaged_ends_test {
namespace {

ConvexPolygon round_face(double radius, int corners, double turned) {
  ConvexPolygon rim;
  for (int i = 0; i < corners; ++i) {
    const double t = 2.0 * std::numbers::pi * (i + turned) / corners;
    rim.emplace_back(radius * std::sin(t), -radius * std::cos(t));
  }
  return rim;
}

/// Rock below the line z_F = height + slope y_F.
Rock rock_below(double height, double slope) {
  mesh::TriangleMesh m = battery::flat_rock(1.0, 0.0, 20);
  for (Vec3& x_W : m.positions) x_W.z() = -height + slope * x_W.y();
  return make_rock(mesh::make_surface(m), 0.2, mesh::bounding_box(m));
}

EngagedEnds ends_in(const Rock& rock, const ConvexPolygon& rim_F) {
  Pose X;
  X.R.col(0) = Vec3::UnitX();
  X.R.col(1) = -Vec3::UnitY();
  X.R.col(2) = -Vec3::UnitZ();
  SectionWork work;
  const SectionFace face = section_face({X, rim_F});
  section(rock, face, {}, {Vec3::Zero(), Vec3::UnitX()}, {0.12, 0.15}, work);
  return engaged_ends(*work.measured, work.sums);
}

/// Of the lower edge, corner by corner.
EngagedEnds ends_below(const ConvexPolygon& rim_F, double height, double slope) {
  EngagedEnds ends;
  for (std::size_t i = 0; i < rim_F.size(); ++i) {
    const Vec2 &p = rim_F[i], &q = rim_F[(i + 1) % rim_F.size()];
    if (!(q.x() > p.x())) continue;  // counter-clockwise: an upper edge
    const double from = height + slope * p.x() - p.y(), to = height + slope * q.x() - q.y();
    if (from <= 0.0 && to <= 0.0) continue;
    const Vec2 crossing = p + from / (from - to) * (q - p);
    const double z_left = from >= 0.0 ? p.y() : crossing.y(),
                 z_right = to >= 0.0 ? q.y() : crossing.y();
    auto& end = ends[q.y() > p.y() ? 1 : 0];
    const double z = std::max(z_left, z_right);
    end = end ? std::max(*end, z) : z;
  }
  return ends;
}

RC_GTEST_PROP(EngagedEnds, are_where_the_edge_leaves_a_plane, ()) {
  const auto any = [](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(*rc::gen::inRange(0, 1000001)) / 1e6;
  };
  const ConvexPolygon rim = round_face(0.3, *rc::gen::inRange(5, 65), any(0.05, 0.95));
  const double height = any(-0.28, 0.1), slope = any(-0.5, 0.5);
  const EngagedEnds found = ends_in(rock_below(height, slope), rim),
                    exact = ends_below(rim, height, slope);
  for (std::size_t side = 0; side < 2; ++side) {
    const bool is_sliver = exact[side] && *exact[side] < -0.3 + 1e-6;
    if (is_sliver) continue;
    RC_ASSERT(found[side].has_value() == exact[side].has_value());
    if (found[side]) RC_ASSERT(std::abs(*found[side] - *exact[side]) < 1e-7);
  }
}

TEST(EngagedEnds, are_none_in_the_open) {
  const EngagedEnds ends = ends_in(rock_below(-0.5, 0.0), round_face(0.3, 16, 0.0));
  EXPECT_FALSE(ends[0]);
  EXPECT_FALSE(ends[1]);
}

}  // namespace
}  // namespace tdbd::rock::engaged_ends_test
