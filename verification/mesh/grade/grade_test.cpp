#include "mesh/grade/grade.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair.hpp"
#include "mesh/shape/convex.hpp"
#include "mesh/surface.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::grade_test {

/// Rounding of coordinates of a few metres, after some tens of edits.
constexpr double rounding = 1e-13;

double length(const TriangleMesh& m, const Side& s) {
  return (m.positions[static_cast<std::size_t>(s.hi)] - m.positions[static_cast<std::size_t>(s.lo)])
      .norm();
}

/// Distance of a point in the unit box from the nearest of its twelve edges.
double distance_from_box_edges(const Vec3& x) {
  double best = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double u = x[(axis + 1) % 3], v = x[(axis + 2) % 3];
    best = std::min(best, std::hypot(std::min(u, 1 - u), std::min(v, 1 - v)));
  }
  return best;
}

GradeOptions options(double edge, double face, double growth, double deviation) {
  return {.edge = edge, .face = face, .growth = growth, .deviation = deviation};
}

/// Fine along the edges of a box, coarse inside its faces, and the same solid.
TEST(Grade, refines_towards_the_edges) {
  const auto o = options(0.02, 0.3, 0.5, 0.0);
  const Graded g = grade(battery::box({0, 0, 0}, {1, 1, 1}), o);
  EXPECT_EQ(g.feature_edges, 12u);
  EXPECT_LE(g.deviation, rounding);
  EXPECT_NEAR(enclosed_volume(g.mesh), 1.0, rounding);
  EXPECT_TRUE(check_solid(g.mesh).empty());
  const std::vector<Side> sides = sorted_sides(g.mesh);
  double at_features = 0.0, inside = 0.0;
  for_each_edge(sides, [&](const Side* s, const Side*) {
    const Vec3 middle = 0.5 * (g.mesh.positions[static_cast<std::size_t>(s->lo)] +
                               g.mesh.positions[static_cast<std::size_t>(s->hi)]);
    const double d = distance_from_box_edges(middle), h = std::min(o.face, o.edge + o.growth * d);
    EXPECT_LE(length(g.mesh, *s), 4.0 / 3.0 * h * (1 + 1e-12));
    if (d < 1e-12) at_features = std::max(at_features, length(g.mesh, *s));
    inside = std::max(inside, length(g.mesh, *s));
  });
  EXPECT_LE(at_features, 4.0 / 3.0 * o.edge);
  EXPECT_GE(inside, 0.2);
  EXPECT_GE(inspect(g.mesh).worst_quality, 0.3);
}

/// A face that is too fine loses facets and stays in place.
TEST(Grade, coarsens_flat_faces_exactly) {
  const TriangleMesh fine =
      grade(battery::box({0, 0, 0}, {1, 1, 1}), options(0.05, 0.05, 0.0, 0.0)).mesh;
  const Graded g = grade(fine, options(0.25, 1.0, 0.5, 0.0));
  EXPECT_LT(g.mesh.triangles.size(), fine.triangles.size() / 5);
  EXPECT_LE(g.deviation, rounding);
  EXPECT_NEAR(enclosed_volume(g.mesh), 1.0, rounding);
  for (const Vec3& x : battery::box({0, 0, 0}, {1, 1, 1}).positions)
    EXPECT_EQ(std::count(g.mesh.positions.begin(), g.mesh.positions.end(), x), 1) << x;
}

/// With no deviation allowed the outline of a cylinder keeps its corners; within one it loses them.
TEST(Grade, keeps_an_outline_within_the_deviation) {
  const TriangleMesh m = battery::cylinder(1.0, 2.0, 256);
  const double sagitta = 1.0 - std::cos(std::numbers::pi / 64);
  const Graded exact = grade(m, options(0.1, 0.5, 0.5, 0.0));
  EXPECT_LE(exact.deviation, rounding);
  EXPECT_GE(exact.mesh.positions.size(), 512u);
  const Graded near = grade(m, options(0.1, 0.5, 0.5, sagitta));
  EXPECT_LE(near.deviation, sagitta + rounding);
  // a lost corner lies at least so far off the chord of its neighbours
  EXPECT_GE(near.deviation, 1.0 - std::cos(2.0 * std::numbers::pi / 256) - rounding);
  EXPECT_LT(near.mesh.positions.size(), exact.mesh.positions.size());
  EXPECT_LE(std::abs(near.volume_change), sagitta * area(m));
  EXPECT_LT(near.volume_change, 0.0);
}

/// A convex part cuts by its planes: grading must not change them.
TEST(Grade, leaves_a_convex_part_its_planes) {
  const TriangleMesh m = battery::cylinder(9.5e-3, 13e-3, 30);
  const auto before = convex_solid(m);
  const auto after = convex_solid(grade(m, options(0.5e-3, 3e-3, 0.5, 0.0)).mesh);
  ASSERT_TRUE(before && after);
  ASSERT_EQ(before->planes, 32u);
  ASSERT_EQ(after->planes, before->planes);
  for (std::size_t i = 0; i < before->planes; ++i) {
    double nearest = 1.0;
    for (std::size_t k = 0; k < after->planes; ++k)
      nearest = std::min(nearest, (normal(*before, i) - normal(*after, k)).norm());
    EXPECT_LE(nearest, 1e-12);
  }
}

TEST(Grade, leaves_a_graded_mesh_nearly_as_it_is) {
  const auto o = options(0.05, 0.4, 0.5, 0.0);
  const TriangleMesh once = grade(battery::prism(battery::l_outline(1, 0.4), 0, 1), o).mesh;
  const TriangleMesh twice = grade(once, o).mesh;
  EXPECT_EQ(twice.triangles.size(), once.triangles.size());
}

TEST(Grade, is_the_same_every_time) {
  const auto o = options(0.1, 0.6, 0.5, 1e-3);
  const Graded a = grade(battery::torus(2, 0.7, 48, 24), o),
               b = grade(battery::torus(2, 0.7, 48, 24), o);
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

TEST(Grade, rejects_what_bounds_no_solid) {
  TriangleMesh open = battery::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_THROW(grade(open, {}), InputError);
}

/// No surface moves by less than nothing.
TEST(Grade, names_a_deviation_that_it_could_not_keep) {
  try {
    grade(battery::box({0, 0, 0}, {1, 1, 1}), options(0.5, 1.0, 0.5, -1e-3));
    FAIL();
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("more than -0.001 m"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("surface moved by"), std::string::npos) << e.what();
  }
}

/// Prisms over stars and Ls, tori, cylinders; any targets; with and without a deviation.
RC_GTEST_PROP(Grade, gives_a_solid_within_its_bounds, ()) {
  const std::vector<TriangleMesh> shapes = {
      battery::prism(battery::star_outline(1, 0.4, *rc::gen::inRange(3, 8)), 0, 0.5),
      battery::prism(battery::l_outline(1, 0.3), -0.5, 0.5),
      battery::torus(2, 0.6, *rc::gen::inRange(6, 40), *rc::gen::inRange(4, 20)),
      battery::cylinder(1, 0.7, *rc::gen::inRange(3, 60)), battery::sphere(1, 3)};
  const TriangleMesh& m = shapes[*rc::gen::inRange<std::size_t>(0, shapes.size())];
  const double edge = 0.05 * *rc::gen::inRange(3, 12);
  const auto o = options(edge, edge * *rc::gen::inRange(1, 8), 0.1 * *rc::gen::inRange(0, 12),
                         *rc::gen::element(0.0, 1e-3, 1e-2));
  const Graded g = grade(m, o);
  RC_ASSERT(check_solid(g.mesh).empty());
  RC_ASSERT(g.deviation <= o.deviation + rounding);
  RC_ASSERT(std::abs(enclosed_volume(g.mesh) - enclosed_volume(m)) <=
            (o.deviation + rounding) * area(m));
  RC_ASSERT(inspect(g.mesh).pieces == inspect(m).pieces);
}

/// A prism whose ends are fans around a vertex each.
TriangleMesh fan_prism(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& middle) {
  TriangleMesh m;
  const int n = static_cast<int>(outline.size());
  for (const double z : {0.0, 1.0}) {
    for (const Eigen::Vector2d& x : outline) m.positions.emplace_back(x.x(), x.y(), z);
    m.positions.emplace_back(middle.x(), middle.y(), z);
  }
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n, up = n + 1;
    m.triangles.push_back({k, i, n});
    m.triangles.push_back({up + i, up + k, up + n});
    m.triangles.push_back({i, k, up + k});
    m.triangles.push_back({i, up + k, up + i});
  }
  return m;
}

/// The mean of an L's corners lies outside it: a vertex that went there would fold the face.
TEST(Relax, folds_no_face) {
  const std::vector<Eigen::Vector2d> l{{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}};
  const TriangleMesh m = fan_prism(l, {0.01, 0.15});
  ASSERT_TRUE(check_solid(m).empty());
  GradeSurface g = make_grade_surface(m, options(0.1, 0.3, 0.5, 0.0));
  ASSERT_EQ(g.place[6], Place::face);
  EXPECT_EQ(relax(g), 0U);
  EXPECT_EQ(g.s.position(6), m.positions[6]);
  // In a square the same vertex goes to the middle.
  const TriangleMesh square = fan_prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0.01, 0.15});
  GradeSurface even = make_grade_surface(square, options(0.1, 0.3, 0.5, 0.0));
  EXPECT_EQ(relax(even), 2U);
  EXPECT_LT((even.s.position(4) - Vec3(0.5, 0.5, 0.0)).norm(), 1e-15);
}

/// The vertex that moves may have any number.
TEST(Relax, moves_the_first_vertex_and_the_last) {
  const TriangleMesh square = fan_prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0.01, 0.15});
  const int n = static_cast<int>(square.positions.size());
  for (const int first : {4, 5}) {  // of those two the middle of an end comes first, or last
    TriangleMesh m = square;
    std::rotate(m.positions.begin(), m.positions.begin() + first, m.positions.end());
    for (Triangle& t : m.triangles)
      for (int& v : t) v = (v + n - first) % n;
    GradeSurface g = make_grade_surface(m, options(0.1, 0.3, 0.5, 0.0));
    EXPECT_EQ(relax(g), 2U);
    EXPECT_LT((g.s.position((4 + n - first) % n) - Vec3(0.5, 0.5, 0.0)).norm(), 1e-15);
  }
}

/// mesh (6) on the unit box: from the length at the edges to that of the faces, and no further.
TEST(Target, grows_from_the_edges_up_to_that_of_the_faces) {
  const auto o = options(0.1, 0.2, 0.5, 0.0);
  const GradeSurface g = make_grade_surface(battery::box({0, 0, 0}, {1, 1, 1}), o);
  for (const double inside : {0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.5})
    for (const double along : {0.3, 0.5}) {
      const Vec3 x(along, inside, 0.0);
      const double expected = std::min(o.face, o.edge + o.growth * distance_from_box_edges(x));
      EXPECT_NEAR(target(g, x), expected, 1e-15) << inside;
    }
}

/// The corners of a regular polygon on the unit circle.
std::vector<Eigen::Vector2d> regular(int corners) {
  std::vector<Eigen::Vector2d> outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi / corners * k;
    outline.emplace_back(std::cos(angle), std::sin(angle));
  }
  return outline;
}

/// The middle of a hexagon of side 1 goes to a corner, which makes a diagonal of 2 in return: allowed from a target of
/// 1.5, where its edges of 1 are below four fifths of it.
TEST(Coarsen, takes_edges_below_four_fifths_of_the_target_and_makes_none_above_four_thirds) {
  const TriangleMesh m = fan_prism(regular(6), {0, 0});
  GradeSurface coarse = make_grade_surface(m, options(1.51, 1.51, 0.0, 0.0)),
               fine = make_grade_surface(m, options(1.49, 1.49, 0.0, 0.0));
  EXPECT_EQ(coarsen(coarse), 2U);
  EXPECT_EQ(coarsen(fine), 0U);
}

/// Where the middle goes to a corner, the corner beside it gets a facet of 180 degrees less a turn: of quality 0.302 in a
/// polygon of 12 corners, 0.279 in one of 13.
TEST(Coarsen, leaves_no_facet_of_a_quality_below_three_tenths) {
  constexpr double coarse = 10.0;
  GradeSurface twelve = make_grade_surface(fan_prism(regular(12), {0, 0}),
                                           options(coarse, coarse, 0.0, 0.0)),
               thirteen = make_grade_surface(fan_prism(regular(13), {0, 0}),
                                             options(coarse, coarse, 0.0, 0.0));
  EXPECT_EQ(coarsen(twelve), 2U);
  EXPECT_EQ(coarsen(thirteen), 0U);
}

/// One of the two middles stands out by 0.01, which is how far the surface moves if it goes.
TEST(Coarsen, moves_the_surface_by_no_more_than_the_deviation) {
  TriangleMesh m = fan_prism(regular(6), {0, 0});
  m.positions.back().z() += 0.01;
  GradeSurface loose = make_grade_surface(m, options(2.0, 2.0, 0.0, 0.0101)),
               tight = make_grade_surface(m, options(2.0, 2.0, 0.0, 0.0099));
  EXPECT_EQ(coarsen(loose), 2U);
  EXPECT_EQ(coarsen(tight), 1U);
  const double moved = *std::ranges::max_element(loose.moved);
  EXPECT_NEAR(moved, 0.01, 1e-15);
}

/// Edges of a surface whose facets meet at more than the angle, smaller vertex first.
std::set<std::pair<int, int>> sharp_edges(const Surface& s, double angle) {
  const auto normal = [&](int t) {
    return area_vector(s.position(s.vertex(3 * t)), s.position(s.vertex(3 * t + 1)),
                       s.position(s.vertex(3 * t + 2)))
        .normalized();
  };
  std::set<std::pair<int, int>> sharp;
  for (int c = 0; c < 3 * s.triangle_slots(); ++c) {
    if (!s.triangle_is_alive(c / 3)) continue;
    const int a = s.vertex(next_corner(c)), b = s.vertex(previous_corner(c));
    if (normal(c / 3).dot(normal(s.opposite_of(c) / 3)) < std::cos(angle))
      sharp.insert({std::min(a, b), std::max(a, b)});
  }
  return sharp;
}

/// A vertex on a straight feature, on none, or at a corner of an outline.
Place place_by_hand(const GradeSurface& g, int v) {
  std::vector<Vec3> ways;
  for (const auto& [a, b] : g.features)
    if (a == v || b == v)
      ways.push_back((g.s.position(a == v ? b : a) - g.s.position(v)).normalized());
  if (ways.empty()) return Place::face;
  return ways.size() == 2 && ways[0].dot(ways[1]) < -0.7 ? Place::crease : Place::corner;
}

/// Whatever the steps do to a prism: its features are where facets meet at an angle, every vertex knows its place, and
/// the outline has all its corners.
RC_GTEST_PROP(GradeSteps, keep_features_and_places_in_step_with_the_shape, ()) {
  const TriangleMesh m =
      *rc::gen::arbitrary<bool>()
          ? battery::prism(battery::star_outline(1, 0.4, *rc::gen::inRange(3, 7)), 0, 0.5)
          : battery::prism(battery::l_outline(1, 0.3), -0.5, 0.5);
  const double edge = 0.05 * *rc::gen::inRange(3, 12);
  GradeSurface g = make_grade_surface(
      m, options(edge, edge * *rc::gen::inRange(1, 6), 0.1 * *rc::gen::inRange(0, 8), 0.0));
  const auto corners = std::ranges::count(g.place, Place::corner);
  for (int k = *rc::gen::inRange(1, 8); k > 0; --k) {
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        refine(g);
        break;
      case 1:
        g.options.edge *= 1.5;
        g.options.face *= 1.5;
        coarsen(g);
        break;
      case 2:
        flip(g);
        break;
      default:
        relax(g);
    }
    RC_ASSERT(adjacency_is_consistent(g.s));
    RC_ASSERT(g.features == sharp_edges(g.s, g.options.angle));
    std::ptrdiff_t kept = 0;
    for (int v = 0; v < g.s.vertex_slots(); ++v) {
      if (!g.s.is_alive(v)) continue;
      RC_ASSERT(g.place[at(v)] == place_by_hand(g, v));
      kept += g.place[at(v)] == Place::corner;
    }
    RC_ASSERT(kept == corners);
    RC_ASSERT(std::abs(enclosed_volume(compact(g.s)) - enclosed_volume(m)) < rounding);
  }
}

/// Longest first: after the two long sides of a box with a square end come the short ones.
TEST(Refine, leaves_no_edge_above_four_thirds_of_the_target_and_splits_none_below) {
  const TriangleMesh m = battery::box({0, 0, 0}, {1, 1, 1});
  GradeSurface coarse = make_grade_surface(m, options(1.07, 1.07, 0.0, 0.0));  // 4/3 of it: 1.427
  EXPECT_EQ(refine(coarse), 0U);
  GradeSurface fine = make_grade_surface(m, options(1.05, 1.05, 0.0, 0.0));  // 1.4: the diagonals
  EXPECT_EQ(refine(fine), 6U);
  EXPECT_EQ(fine.s.vertex_count(), 14);
}

/// A prism over a slender kite, both ends cut along it: cut across they have far better facets.
TEST(Flip, takes_the_better_diagonal_of_each_flat_pair) {
  const TriangleMesh m{{{0, 0, 0},
                        {0.5, -0.1, 0},
                        {1, 0, 0},
                        {0.5, 0.1, 0},
                        {0, 0, 1},
                        {0.5, -0.1, 1},
                        {1, 0, 1},
                        {0.5, 0.1, 1}},
                       {{2, 1, 0},
                        {3, 2, 0},
                        {4, 5, 6},
                        {4, 6, 7},
                        {0, 1, 5},
                        {0, 5, 4},
                        {1, 2, 6},
                        {1, 6, 5},
                        {2, 3, 7},
                        {2, 7, 6},
                        {3, 0, 4},
                        {3, 4, 7}}};
  ASSERT_TRUE(check_solid(m).empty());
  GradeSurface g = make_grade_surface(m, options(0.1, 0.3, 0.5, 0.0));
  EXPECT_EQ(flip(g), 2U);
  const TriangleMesh flipped = compact(g.s);
  EXPECT_TRUE(check_solid(flipped).empty());
  EXPECT_NEAR(enclosed_volume(flipped), 0.1, 1e-15);
  EXPECT_GT(inspect(flipped).worst_quality, 1.2 * inspect(m).worst_quality);
  EXPECT_EQ(flip(g), 0U);
}

}  // namespace tdbd::mesh::grade_test
