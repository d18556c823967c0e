#include "rock/maintain/check_operation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "mesh/edit.hpp"
#include "rock/maintain/collapse.hpp"
#include "verification/battery/rock_surfaces.hpp"

namespace tdbd::rock::check_operation_test {

constexpr int inner = 60;  // the middle of 11 x 11 vertices

/// Edges of 0.3 m, or as many times that.
Rock sheet(double size = 1.0) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.1, 7);
  for (Vec3& x_W : m.positions) x_W *= size;
  return make_rock(mesh::make_surface(m), 0.5 * size, mesh::bounding_box(m));
}

void expect_nothing_wrong_with_a_bisection(Rock rock) {
  const int c = rock.surface.corner_of[inner];
  const int a = rock.surface.vertex(mesh::next_corner(c)),
            b = rock.surface.vertex(mesh::previous_corner(c));
  const LocalState before = local_state(rock.surface, {a, b, inner});
  const int m = mesh::split_edge(rock.surface, c,
                                 0.5 * (rock.surface.position(a) + rock.surface.position(b)));
  register_vertex(rock, m, -1);
  EXPECT_EQ(describe(check_around(rock, before, 0.0)), "");
  EXPECT_NO_THROW(require_promises_around(rock, before, 0.0, "bisections"));
}

TEST(CheckOperation, finds_nothing_wrong_with_a_bisection) {
  for (const double size : {1.0, 1e-3, 1e3}) expect_nothing_wrong_with_a_bisection(sheet(size));
}

/// One of the vertices that were there before is no more.
TEST(CheckOperation, finds_nothing_wrong_with_a_collapse_but_its_volume) {
  Rock rock = sheet();
  const mesh::Surface& s = rock.surface;
  const int c = s.corner_of[inner];
  const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
  std::vector<int> around{a, b};
  for (const int v : {a, b})
    around.insert(around.end(), s.ring(s.star(v)), s.ring(s.star(v)) + s.star(v).size);
  const LocalState before = local_state(s, around);
  MaintenanceLimits limits = limits_for(1.0);
  limits.volume_per_operation = limits.farthest = limits.ridge_cut = 1.0;
  SurfaceDrift drift;
  MaintenanceReport report;
  ASSERT_TRUE(try_collapse(rock, a, b, limits, around, drift, report));
  EXPECT_NE(s.is_alive(a), s.is_alive(b));
  EXPECT_EQ(describe(check_around(rock, before, report.volume_change)), "");
  EXPECT_NE(describe(check_around(rock, before, report.volume_change + 1e-6)).find("M5"),
            std::string::npos);
}

/// However small or large the triangles are.
TEST(CheckOperation, notices_volume_that_was_not_reported) {
  for (const double size : {1.0, 1e-6, 1e3}) {
    Rock rock = sheet(size);
    const LocalState before = local_state(rock.surface, {inner});
    Vec3& x_W = rock.surface.stars[inner].x;
    x_W.z() += 1e-6 * size;
    rock.grid.move(inner, x_W);
    EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M5"), std::string::npos) << size;
    EXPECT_THROW(require_promises_around(rock, before, 0.0, "smoothings"), RunError);
  }
}

/// What is small is measured by the triangles around, not by how far from the origin they are.
TEST(CheckOperation, notices_a_small_volume_far_from_the_origin) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.1, 7);
  for (Vec3& x_W : m.positions) x_W += Vec3(100.0, -200.0, 300.0);
  Rock rock = make_rock(mesh::make_surface(m), 0.5, mesh::bounding_box(m));
  const LocalState before = local_state(rock.surface, {inner});
  EXPECT_LT(before.size, 0.5);
  Vec3& x_W = rock.surface.stars[inner].x;
  x_W.z() += 1e-8;
  rock.grid.move(inner, x_W);
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M5"), std::string::npos);
}

TEST(CheckOperation, notices_wrong_adjacency_and_an_index_out_of_step) {
  Rock rock = sheet();
  const LocalState before = local_state(rock.surface, {inner});
  const int c = rock.surface.corner_of[inner];
  std::swap(rock.surface.opposite[static_cast<std::size_t>(c)],
            rock.surface.opposite[static_cast<std::size_t>(mesh::next_corner(c))]);
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M1"), std::string::npos);
  rock = sheet();
  rock.surface.stars[inner].x.z() += 1e-6;
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("index"), std::string::npos);
}

/// Also behind a vertex that is no more.
TEST(CheckOperation, notices_an_index_out_of_step_whatever_died_before) {
  Rock rock = sheet();
  const mesh::Surface& s = rock.surface;
  const int c = s.corner_of[inner];
  const int keep = s.vertex(mesh::next_corner(c)), gone = s.vertex(mesh::previous_corner(c));
  const LocalState before = local_state(s, {gone, keep});
  const Vec3 x_W = s.position(keep);
  mesh::collapse_edge(rock.surface, c, x_W);
  rock.grid.remove(gone);
  rock.grid.move(keep, x_W + Vec3(0.0, 0.0, 1e-3));
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("index"), std::string::npos);
}

/// Corner 0 is a corner like others: the triangle beyond its edge notices that it points elsewhere.
TEST(CheckOperation, notices_a_wrong_neighbour_of_the_first_corner) {
  Rock rock = sheet();
  const int c = rock.surface.opposite_of(0);
  ASSERT_GE(c, 0);
  const LocalState before = local_state(rock.surface, {rock.surface.vertex(c)});
  ASSERT_EQ(describe(check_around(rock, before, 0.0)), "");
  rock.surface.opposite[0] = -1;
  EXPECT_NE(describe(check_around(rock, before, 0.0)).find("M1"), std::string::npos);
}

}  // namespace tdbd::rock::check_operation_test
