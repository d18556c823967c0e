#include "rock/maintain/invariants.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <tuple>
#include <vector>

#include "rock/maintain/maintain.hpp"
#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/touched_region.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/cut/cutting_scene.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::invariants_test {

/// Rock before and after one maintenance that a random cut made necessary.
struct Maintained {
  MaintenanceLimits limits;
  Rock before, after;
  MaintenanceReport report;
  MaintenanceWorkspace work;
};

Maintained maintained(const Wildness& wild = {}) {
  const Scene s = *scene(wild);
  Maintained m;
  m.before = rock_of(s);
  CutWorkspace cut_work;
  CutReport cut;
  cut_rock(m.before, prepare_cutting_bit(s.bit), s.X_WB0, s.X_WB1, cut_work, cut);
  const double h = 3.0 / std::sqrt(0.5 * m.before.surface.triangle_count());
  m.limits = bare_limits_for(h * *battery::number(0.7, 2.0));
  m.limits.flip_quality = *battery::integer(0, 1) * *battery::number(0.0, 1.0);
  m.limits.smoothing = *battery::integer(0, 1) == 0 ? Smoothing::off : Smoothing::tangential;
  m.limits.smooth_quality = *battery::number(0.0, 1.0);
  m.after = m.before;
  maintain(m.after, m.limits, m.work, m.report);
  return m;
}

/// M1 to M3 and M5 to M7, with and without flips and smoothing.
RC_GTEST_PROP(Invariants, are_satisfied_after_one_maintenance, ()) {
  const Maintained m = maintained();
  RC_ASSERT(describe(check_maintenance(m.before, m.after, m.limits, m.report, m.work.drift)) == "");
}

/// A sheet of edges 0.3 and 0.42, with every vertex touched.
Rock sheet() {
  const mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.1, 7);
  Rock rock = make_rock(mesh::make_surface(m), 0.5, mesh::bounding_box(m));
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) touch(rock, v);
  return rock;
}

int inner_vertex(const Rock& rock) {
  int v = rock.surface.vertex_slots() / 2;
  while (rock.surface.is_boundary(v)) ++v;
  return v;
}

bool names(const std::vector<Violation>& found, Invariant which) {
  return std::ranges::any_of(found, [&](const Violation& v) { return v.which == which; });
}

TEST(Invariants, find_nothing_wrong_with_a_sound_sheet) {
  const Rock rock = sheet();
  EXPECT_EQ(describe(check_maintenance(rock, rock, bare_limits_for(0.35), {})), "");
}

TEST(Invariants, notice_wrong_adjacency) {
  Rock rock = sheet();
  std::swap(rock.surface.opposite[40], rock.surface.opposite[41]);
  EXPECT_TRUE(names(check_disc(rock), Invariant::disc));
}

TEST(Invariants, notice_a_hole) {
  Rock rock = sheet();
  rock.surface.triangles[90] = {-1, -1, -1};
  EXPECT_TRUE(names(check_disc(rock), Invariant::disc));
}

TEST(Invariants, notice_an_index_out_of_step) {
  Rock rock = sheet();
  const int v = inner_vertex(rock);
  rock.surface.stars[static_cast<std::size_t>(v)].x.z() += 0.01;
  EXPECT_TRUE(names(check_disc(rock), Invariant::disc));
  rock = sheet();
  rock.grid.remove(v);
  const auto found = check_disc(rock);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].where.find(std::to_string(v)), std::string::npos) << found[0].where;
}

TEST(Invariants, notice_repairs_left_undone) {
  const Rock rock = sheet();
  const std::vector<RepairScope> everywhere(rock.surface.stars.size(), RepairScope::all);
  MaintenanceLimits limits =
      bare_limits_for(0.8);  // shortest 0.32: many sides of cells are shorter
  limits.volume_per_operation = 1.0;
  EXPECT_TRUE(names(check_repairs(rock.surface, everywhere, limits), Invariant::edges));
  limits = bare_limits_for(0.2);  // longest 0.32: the diagonals are longer
  EXPECT_TRUE(names(check_repairs(rock.surface, everywhere, limits), Invariant::edges));
  limits = bare_limits_for(0.8);
  limits.shortest_edge = 0.0;
  limits.worst_quality = 0.99;
  limits.volume_per_operation = 1.0;
  EXPECT_TRUE(names(check_repairs(rock.surface, everywhere, limits), Invariant::quality));
}

/// How many triangles have a quality below `worst` and a shortest edge that would collapse, edge by edge.
std::ptrdiff_t shapes_to_collapse(const mesh::Surface& s, const MaintenanceLimits& limits) {
  std::ptrdiff_t count = 0;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    std::vector<std::tuple<double, int, int>> edges;
    for (int c = 3 * t; c < 3 * t + 3; ++c) {
      const auto [a, b] =
          std::minmax({s.vertex(mesh::next_corner(c)), s.vertex(mesh::previous_corner(c))});
      edges.emplace_back((s.position(a) - s.position(b)).norm(), a, b);
    }
    const auto& [length, a, b] = *std::ranges::min_element(edges);
    count += quality(facet_at(s, 3 * t)) < limits.worst_quality &&
             is_accepted(judge_collapse(s, a, b, limits));
  }
  return count;
}

/// A thin triangle is mended at its shortest edge, whatever the longest one allows.
RC_GTEST_PROP(Invariants, notice_thin_triangles_whose_shortest_edge_would_collapse, ()) {
  const mesh::Surface s = mesh::make_surface(battery::bumpy_rock(
      1.5, *battery::integer(6, 12), *battery::number(0.0, 0.2), *battery::integer(0, 1000)));
  MaintenanceLimits limits = bare_limits_for(*battery::number(0.2, 0.6));
  limits.shortest_edge = 0.0;
  limits.flip_quality = 0.0;
  limits.worst_quality = *battery::number(0.5, 1.0);
  limits.volume_per_operation = 1.0;
  const auto found =
      check_repairs(s, std::vector(s.stars.size(), RepairScope::no_bisections), limits);
  RC_ASSERT(std::ssize(found) == shapes_to_collapse(s, limits));
}

TEST(Invariants, notice_a_normal_turned_over) {
  const Rock rock = sheet();
  mesh::Surface turned = rock.surface;
  turned.stars[static_cast<std::size_t>(inner_vertex(rock))].x.x() += 0.7;
  EXPECT_TRUE(names(check_normals(rock.surface, turned), Invariant::normals));
  EXPECT_TRUE(check_normals(rock.surface, rock.surface).empty());
}

TEST(Invariants, notice_volume_that_was_not_reported) {
  const Rock rock = sheet();
  EXPECT_TRUE(names(check_ledger(rock.surface, rock.surface, 1e-9), Invariant::ledger));
}

/// A plane's vertex lifted by d: the new surface strays d from the old one, at that vertex.
TEST(Invariants, measure_how_far_a_surface_strays) {
  const mesh::TriangleMesh flat = battery::bumpy_rock(1.5, 10, 0.0, 7);
  const mesh::Surface before = mesh::make_surface(flat);
  mesh::Surface after = before;
  const double d = 0.05;
  after.stars[60].x.z() -= d;
  ASSERT_FALSE(before.is_boundary(60));
  const Deviation there = deviation(after, before, 1.0);
  EXPECT_DOUBLE_EQ(there.distance, d);
  EXPECT_EQ(there.x_W, after.position(60));
  EXPECT_LT(deviation(before, after, 1.0).distance, d);  // its nearest point is on the slope
  EXPECT_GT(deviation(before, after, 1.0).distance, 0.5 * d);
  MaintenanceLimits limits = bare_limits_for(0.3);  // half of its shortest edge: 0.06
  EXPECT_TRUE(check_distance(before, after, limits).empty());
  limits.shortest_edge = 1.9 * d;
  EXPECT_TRUE(names(check_distance(before, after, limits), Invariant::distance));
}

TEST(Invariants, notice_untouched_rock_and_boundary_that_changed) {
  Rock before = sheet();
  before.touched.assign(before.touched.size(), 0);
  mesh::Surface after = before.surface;
  const int v = inner_vertex(before);
  after.stars[static_cast<std::size_t>(v)].x.z() += 1e-16 + 1e-3;
  EXPECT_TRUE(names(check_locality(before, after), Invariant::locality));
  before.touched[static_cast<std::size_t>(v)] = 1;
  EXPECT_TRUE(check_locality(before, after).empty());
  after.stars[0].x.z() += 1e-12;
  EXPECT_TRUE(names(check_locality(before, after), Invariant::locality));
}

/// The least number of edges from v to w, up to 3.
int edges_between(const mesh::Surface& s, int v, int w) {
  std::set<int> reached{v};
  for (int n = 0; n < 3; ++n) {
    if (reached.count(w) != 0) return n;
    for (const int one : std::set<int>(reached))
      for (const mesh::Triangle& t : s.triangles)
        if (std::ranges::count(t, one) != 0) reached.insert(t.begin(), t.end());
  }
  return 3;
}

/// What a touched vertex excuses: changes at its neighbours, none farther off.
TEST(Invariants, excuse_changes_up_to_the_neighbours_of_a_touched_vertex) {
  const Rock before = sheet();
  const int v = inner_vertex(before);
  mesh::Surface after = before.surface;
  after.stars[static_cast<std::size_t>(v)].x.z() += 1e-3;
  for (int w = 0; w < before.surface.vertex_slots(); ++w) {
    Rock one = before;
    one.touched.assign(one.touched.size(), 0);
    one.touched[static_cast<std::size_t>(w)] = 1;
    const bool is_near = edges_between(before.surface, v, w) <= 2;
    EXPECT_EQ(check_locality(one, after).empty(), is_near) << "vertex " << w;
  }
}

/// A crumpled sheet some of whose vertices are touched, and limits around its edges of 0.3.
struct Touched {
  Rock rock = rock_of(any_sheet(*battery::number(0.1, 1.2)));
  MaintenanceLimits limits = bare_limits_for(*battery::number(0.2, 0.5));
  std::vector<int> vertices;

  Touched() {
    limits.worst_quality = *battery::number(0.01, 0.5);
    limits.flip_quality = *battery::number(0.0, 1.0);
    limits.smooth_quality = *battery::number(0.0, 1.0);
    limits.smoothing = Smoothing::tangential;
    for (int k = *battery::integer(1, 12); k > 0; --k) {
      vertices.push_back(*battery::integer(0, rock.surface.vertex_slots() - 1));
      touch(rock, vertices.back());
    }
  }
};

std::vector<int> sorted(std::vector<int> list) {
  std::ranges::sort(list);
  return list;
}

Vec3 area_of(const mesh::Surface& s, int t) {
  const auto& [a, b, c] = s.triangles[at(t)];
  return mesh::area_vector(s.position(a), s.position(b), s.position(c));
}

double quality_of(const mesh::Surface& s, int t) {
  const auto& [a, b, c] = s.triangles[at(t)];
  return mesh::triangle_quality(s.position(a), s.position(b), s.position(c));
}

double edge_of(const mesh::Surface& s, int t, std::size_t i) {
  const mesh::Triangle& v = s.triangles[at(t)];
  return (s.position(v[(i + 1) % 3]) - s.position(v[(i + 2) % 3])).norm();
}

/// Whether a neighbour lies back to back: the normals are more than 120 degrees apart.
bool is_folded(const mesh::Surface& s, int t) {
  for (int c = 3 * t; c < 3 * t + 3; ++c) {
    const int o = s.opposite_of(c);
    if (o >= 0 && area_of(s, t).normalized().dot(area_of(s, o / 3).normalized()) < -0.5)
      return true;
  }
  return false;
}

/// Each triangle at touched vertices that violates a limit, once.
RC_GTEST_PROP(TouchedRegion, has_every_touched_triangle_under_what_it_needs, ()) {
  Touched x;
  const mesh::Surface& s = x.rock.surface;
  TouchedRegion region;
  region.fine_rings = RingSkipping::classified;
  std::vector<int> unknown;
  begin_notes(x.rock, x.limits, OldNotes::used, unknown);
  classify_touched_triangles(x.rock, x.limits, region);
  const auto wanted = [&](const std::function<bool(int)>& is_wanted) {
    std::vector<int> found;
    for (int t = 0; t < s.triangle_slots(); ++t)
      if (std::ranges::any_of(s.triangles[at(t)],
                              [&](int v) { return std::ranges::count(x.vertices, v) > 0; }) &&
          is_wanted(t))
        found.push_back(t);
    return found;
  };
  const auto shortest = [&](int t) {
    return std::min({edge_of(s, t, 0), edge_of(s, t, 1), edge_of(s, t, 2)});
  };
  const auto longest = [&](int t) {
    return std::max({edge_of(s, t, 0), edge_of(s, t, 1), edge_of(s, t, 2)});
  };
  const MaintenanceLimits& l = x.limits;
  RC_ASSERT(sorted(region.triangles) == wanted([](int) { return true; }));
  RC_ASSERT(region.asked == static_cast<long>(region.triangles.size()));
  RC_ASSERT(sorted(region.with_long_edges) ==
            wanted([&](int t) { return longest(t) > l.longest_edge; }));
  RC_ASSERT(sorted(region.to_flip) ==
            wanted([&](int t) { return quality_of(s, t) < l.flip_quality; }));
  RC_ASSERT(sorted(region.to_smooth) ==
            wanted([&](int t) { return quality_of(s, t) < l.smooth_quality; }));
  RC_ASSERT(sorted(region.steep) == wanted([&](int t) {
              return -area_of(s, t).z() < 0.5 * l.shortest_edge * l.shortest_edge;
            }));
  RC_ASSERT(sorted(region.to_collapse) == wanted([&](int t) {
              return shortest(t) < l.shortest_edge || quality_of(s, t) < l.worst_quality ||
                     is_folded(s, t);
            }));
  for (int t = 0; t < s.triangle_slots(); ++t) {
    const int place = place_of(region, t);
    if (place >= 0)
      RC_ASSERT(region.triangles[at(place)] == t);
    else
      RC_ASSERT(std::ranges::count(region.triangles, t) == 0);
  }
}

/// The limits are compared with squares of lengths and of quality.
RC_GTEST_PROP(Shape, has_squared_lengths_and_quality, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 1.0)));
  const mesh::Surface& s = rock.surface;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    const Shape shape = shape_of(s, t);
    for (std::size_t i = 0; i < 3; ++i)
      RC_ASSERT(std::abs(std::sqrt(shape.edge2[i]) - edge_of(s, t, i)) < 1e-14);
    RC_ASSERT(std::abs(std::sqrt(shape.quality2) - quality_of(s, t)) < 1e-14);
    RC_ASSERT((0.5 * shape.doubled_area - area_of(s, t)).norm() < 1e-15);
  }
}

/// After a classification only what is touched again has changed.
TEST(TouchedRegion, finds_what_changed_since) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 7));
  for (const int v : {40, 50, 60}) touch(rock, v);
  TouchedRegion region;
  std::vector<int> unknown;
  begin_notes(rock, bare_limits_for(0.3), OldNotes::used, unknown);
  classify_touched_triangles(rock, bare_limits_for(0.3), region);
  find_changed(rock, region);
  EXPECT_TRUE(region.changed.empty());
  touch(rock, 50);
  touch(rock, 70);
  find_changed(rock, region);
  EXPECT_EQ(sorted(region.changed), (std::vector{50, 70}));
}

}  // namespace tdbd::rock::invariants_test
