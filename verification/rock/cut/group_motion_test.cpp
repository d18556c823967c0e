#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "rock/cut/group_cut.hpp"
#include "rock/cut/swept_part.hpp"
#include "rotation/screw.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::rock::group_motion_test {

bit::Bit bit_of(const mesh::TriangleMesh& m, const Pose& X_BP) {
  bit::Bit bit;
  bit.parts.push_back({});
  bit.parts.back().mesh_P = m;
  bit.parts.back().X_BP = X_BP;
  return bit;
}

/// A bit near the axis of space, turned and tilted a little, that turns on in the step.
struct Move {
  Pose X_WB0, X_WB1;
};

Move any_move() {
  Move m;
  m.X_WB0 = {rotation::exp(*battery::number(-3.0, 3.0) * Vec3::UnitZ() +
                           *battery::number(0.0, 0.05) * *battery::direction()),
             *battery::number(0.0, 0.3) * *battery::direction()};
  m.X_WB1 = {m.X_WB0.R * rotation::exp(*battery::number(-0.3, 0.3) * *battery::direction()),
             m.X_WB0.p + *battery::number(0.0, 0.1) * *battery::direction()};
  return m;
}

bool is_swept_by(const CuttingBit& bit, const GroupMotion& m, const Vec3& x_W) {
  SweptScratch scratch;
  const RelativePath path{m.X_PW0 * x_W, m.X_PW1 * x_W, Vec3::UnitZ(), Vec3::UnitZ()};
  return is_swept(bit.groups[0].parts[0], path, scratch);
}

/// Vertices without triangles: all that a search for candidates reads of a surface.
mesh::Surface vertices_at(const std::vector<Vec3>& positions_W) {
  mesh::Surface s;
  for (const Vec3& x_W : positions_W) s.stars.emplace_back().x = x_W;
  return s;
}

std::vector<int> candidates_in(const VertexGrid& grid, const std::vector<Vec3>& positions_W,
                               const CuttingGroup& g, const GroupMotion& m,
                               const NearListMargins& margins = {}) {
  NearList list;
  NearGroup near;
  if (is_out_of_reach(grid, m)) return {};
  update_near_list(grid, {g.box_P, m.X_WP0, m.X_WP1, m.region_W}, margins, list);
  find_candidates(g, m, vertices_at(positions_W), list, -1.0, near);
  for (int& v : near.places) v = list.v[static_cast<std::size_t>(v)];
  return near.places;
}

/// Around the part, so that about half are swept.
std::vector<Vec3> points_near(const GroupMotion& m) {
  std::vector<Vec3> points;
  const mesh::Box& box = m.region_W.box;
  for (int k = 0; k < 50; ++k)
    points.push_back(box.lo + 0.5 * (*battery::point(1.2) + Vec3::Ones()).cwiseProduct(box.size()));
  return points;
}

/// Neither region, nor hull, nor reach drops a vertex that is swept.
RC_GTEST_PROP(FindCandidates, finds_all_that_is_swept, ()) {
  const CuttingBit bit = prepare_cutting_bit(bit_of(
      *rc::gen::oneOf(battery::convex_polyhedron(), battery::star_shape()), *battery::pose(2.0)));
  const Move move = *rc::gen::exec(any_move);
  const GroupMotion m = group_motion(bit.groups[0], move.X_WB0, move.X_WB1);
  const std::vector<Vec3> points = points_near(m);
  VertexGrid grid(m.region_W.box, 0.3);
  for (std::size_t v = 0; v < points.size(); ++v) grid.insert(static_cast<int>(v), points[v]);
  const std::vector<int> candidates = candidates_in(grid, points, bit.groups[0], m);
  for (std::size_t v = 0; v < points.size(); ++v)
    if (is_swept_by(bit, m, points[v]))
      RC_ASSERT(std::ranges::count(candidates, static_cast<int>(v)) == 1);
}

/// Neither region, nor ball, nor hull drops a vertex that a plane of the hull keeps away by less
/// than the gap at the end.
RC_GTEST_PROP(FindCandidates, finds_all_that_is_touched, ()) {
  const CuttingBit bit = prepare_cutting_bit(bit_of(*battery::convex_polyhedron(), {}));
  const Move move = *rc::gen::exec(any_move);
  const CuttingGroup& g = bit.groups[0];
  const GroupMotion m = group_motion(g, move.X_WB0, move.X_WB1);
  const double gap = *battery::number(0.0, 0.2);
  const std::vector<Vec3> points = points_near(m);
  const Region region = widened(m.region_W, gap);
  VertexGrid grid(region.box, 0.3);
  for (std::size_t v = 0; v < points.size(); ++v) grid.insert(static_cast<int>(v), points[v]);
  NearList list;
  update_near_list(grid, {g.box_P, m.X_WP0, m.X_WP1, region}, {}, list);
  NearGroup near;
  find_candidates(g, m, vertices_at(points), list, gap, near);
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!is_far_from(g, m.X_PW1 * points[v], gap))
      RC_ASSERT(std::ranges::count(near.touching, static_cast<int>(v)) == 1);
}

/// A resumed run makes other lists than the uninterrupted run. Half of the points lie outside a
/// plane of the hull by about the slack that lists keep for rounding.
RC_GTEST_PROP(FindCandidates, finds_the_same_from_any_list, ()) {
  const CuttingBit bit = prepare_cutting_bit(bit_of(*battery::convex_polyhedron(), {}));
  const Move move = *rc::gen::exec(any_move);
  const CuttingGroup& g = bit.groups[0];
  const GroupMotion m = group_motion(g, move.X_WB0, move.X_WB1);
  std::vector<Vec3> points = points_near(m);
  const double room = single_slack(m.region_W.box);
  for (std::size_t v = 0; v < points.size(); v += 2) {
    const std::size_t i = v % g.hull_P.planes;
    const Vec3 x_P = m.X_PW0 * points[v], n = mesh::normal(g.hull_P, i);
    points[v] =
        m.X_WP0 * Vec3(x_P + (g.hull_P.b[i] + *battery::number(0.0, 8.0) * room - n.dot(x_P)) * n);
  }
  VertexGrid grid(m.region_W.box, 0.3);
  for (std::size_t v = 0; v < points.size(); ++v) grid.insert(static_cast<int>(v), points[v]);
  std::vector<int> tight = candidates_in(grid, points, g, m), wide;
  wide =
      candidates_in(grid, points, g, m, {*battery::number(0.0, 2.0), *battery::number(0.0, 3.0)});
  std::ranges::sort(tight);
  std::ranges::sort(wide);
  RC_ASSERT(tight == wide);
}

/// A group that stays nearer to the axis than the rock at its heights searches none of it.
TEST(FindCandidates, leaves_a_wall_alone_that_is_out_of_reach) {
  const CuttingBit bit =
      prepare_cutting_bit(bit_of(battery::box({0.9, -0.1, -0.1}, {1.0, 0.1, 0.1}), Pose{}));
  const double reach = std::hypot(1.0, 0.1);
  const Pose still, turned{rotation::exp(Vec3(0, 0, 0.01)), Vec3::Zero()};
  const GroupMotion m = group_motion(bit.groups[0], still, turned);
  EXPECT_NEAR(m.reach_W, reach, 2e-5);
  const auto candidates_at = [&](double r) {
    VertexGrid grid({Vec3(-2, -2, -1), Vec3(2, 2, 1)}, 0.1);
    std::vector<Vec3> points;
    for (int k = 0; k < 100; ++k) {
      points.emplace_back(r * std::cos(0.001 * k), r * std::sin(0.001 * k), 0.0);
      grid.insert(k, points.back());
    }
    EXPECT_EQ(is_out_of_reach(grid, m), r > m.reach_W);
    return candidates_in(grid, points, bit.groups[0], m).size();
  };
  EXPECT_EQ(candidates_at(reach + 1e-3), 0U);
  EXPECT_GT(candidates_at(reach - 0.02), 0U);
}

/// A vertex goes along chords, which are nearer to the axis than their ends by the cosine of half the turn.
TEST(FindCandidates, reaches_as_far_as_chords_require) {
  const CuttingBit bit =
      prepare_cutting_bit(bit_of(battery::box({0.9, -0.1, -0.1}, {1.0, 0.1, 0.1}), Pose{}));
  const double reach = std::hypot(1.0, 0.1);
  for (const double from : {0.0, 0.7, -2.0})
    for (const double turn : {0.0, 0.3, -1.0, 1.8}) {
      const Pose start{rotation::exp(Vec3(0, 0, from)), Vec3::Zero()};
      const Pose end{rotation::exp(Vec3(0, 0, from + turn)), Vec3::Zero()};
      EXPECT_NEAR(group_motion(bit.groups[0], start, end).reach_W, reach / std::cos(0.5 * turn),
                  1e-14);
    }
}

}  // namespace tdbd::rock::group_motion_test

namespace tdbd::rock::mapped_direction_test {

/// One part with a core, in a bit that makes any small move.
struct Cored {
  bit::Bit bit;
  Pose X_WB0, X_WB1;
};

Cored any_cored() {
  Cored c;
  bit::Part& part = c.bit.parts.emplace_back();
  part.mesh_P = *battery::convex_polyhedron();
  part.X_BP = *battery::pose(2.0);
  part.core_P = bit::Segment{*battery::point(0.3), *battery::point(0.3)};
  part.update_direction_B = Vec3(0.6, 0.0, 0.8);
  c.X_WB0 = *battery::pose(1.0);
  c.X_WB1 = c.X_WB0 * Pose{Mat3::Identity(), 0.05 * *battery::direction()};
  return c;
}

/// Outwards, around and down in the bit frame at pose 1, of a vector at x.
Vec3 cylindrical(const Pose& X_WB1, const Vec3& x_W, const Vec3& u_W) {
  const Vec3 x_B = inverse(X_WB1) * x_W, u_B = X_WB1.R.transpose() * u_W;
  const Vec3 out = Vec3(x_B.x(), x_B.y(), 0.0).normalized();
  return {u_B.dot(out), u_B.dot(Vec3::UnitZ().cross(out)), u_B.z()};
}

RC_GTEST_PROP(MappedDirectionW, lies_in_the_half_plane_outwards_and_down, ()) {
  const Cored c = any_cored();
  const CuttingBit cutting = prepare_cutting_bit(c.bit);
  const GroupMotion m = group_motion(cutting.groups[0], c.X_WB0, c.X_WB1);
  const Vec3 x_W = c.X_WB1 * *battery::point(2.0);
  const Vec3 u = cylindrical(c.X_WB1, x_W, mapped_direction_W(cutting.groups[0], m, x_W));
  RC_ASSERT(u.x() >= -1e-15 && u.z() >= -1e-15);
  RC_ASSERT(std::abs(u.y()) < 1e-14);
  RC_ASSERT(std::abs(u.norm() - 1.0) < 1e-14);
}

/// The twin: the nearest of many points of the core, in space, halfway through the step.
RC_GTEST_PROP(MappedDirectionW, is_the_normal_about_the_core_where_that_points_out_and_down, ()) {
  Cored c = any_cored();
  c.X_WB1 = c.X_WB0;  // at rest: halfway is here
  const bit::Part& part = c.bit.parts[0];
  const CuttingBit cutting = prepare_cutting_bit(c.bit);
  const GroupMotion m = group_motion(cutting.groups[0], c.X_WB0, c.X_WB1);
  const Vec3 x_W = c.X_WB1 * *battery::point(2.0);
  constexpr int samples = 20000;
  Vec3 nearest_W = Vec3::Constant(1e9);
  for (int k = 0; k <= samples; ++k) {
    const Vec3 p_P = part.core_P->from +
                     static_cast<double>(k) / samples * (part.core_P->to - part.core_P->from);
    const Vec3 p_W = c.X_WB1 * (part.X_BP * p_P);
    if ((x_W - p_W).norm() < (x_W - nearest_W).norm()) nearest_W = p_W;
  }
  const Vec3 n = cylindrical(c.X_WB1, x_W, x_W - nearest_W);
  RC_PRE(std::max(n.x(), n.z()) > 0.05);
  const Vec3 along(std::max(0.0, n.x()), 0.0, std::max(0.0, n.z()));
  const Vec3 u = cylindrical(c.X_WB1, x_W, mapped_direction_W(cutting.groups[0], m, x_W));
  const double spacing = (part.core_P->to - part.core_P->from).norm() / samples;
  constexpr double rounding = 1e-14;
  RC_ASSERT((u - along.normalized()).norm() < 0.5 * spacing / along.norm() + rounding);
}

TEST(MappedDirectionW, is_the_groups_own_where_the_normal_points_up_and_in) {
  bit::Bit bit;
  bit::Part& part = bit.parts.emplace_back();
  part.mesh_P = battery::box(Vec3::Constant(-0.1), Vec3::Constant(0.1));
  part.X_BP.p = Vec3(1.0, 0.0, 0.0);
  part.core_P = bit::Segment{Vec3::Zero(), Vec3::Zero()};
  part.update_direction_B = Vec3(0.6, 0.0, 0.8);
  const CuttingBit cutting = prepare_cutting_bit(bit);
  const GroupMotion m = group_motion(cutting.groups[0], Pose{}, Pose{});
  EXPECT_EQ(mapped_direction_W(cutting.groups[0], m, Vec3(0.95, 0.0, -0.05)), Vec3(0.6, 0, 0.8));
  EXPECT_EQ(mapped_direction_W(cutting.groups[0], m, Vec3(1.05, 0.0, -0.05)), Vec3(1, 0, 0));
  EXPECT_EQ(mapped_direction_W(cutting.groups[0], m, Vec3(0.95, 0.0, 0.05)), Vec3(0, 0, 1));
}

}  // namespace tdbd::rock::mapped_direction_test
