#include "mesh/repair/repair.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/measures.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "verification/battery/shapes.hpp"

namespace tdbd::mesh::repair_test {

const TriangleMesh unit_box = battery::box({0, 0, 0}, {1, 1, 1});

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  return merged({{"a", a}, {"b", b}});
}

void turn(TriangleMesh& m, std::size_t i) { std::swap(m.triangles[i][1], m.triangles[i][2]); }

/// What was done, as "12 points merged at equal places".
std::string steps_of(const Repaired& r) {
  std::string text;
  for (const RepairStep& step : r.steps)
    text += std::to_string(step.count) + " " + step.what + "\n";
  return text;
}

void expect_box(const Repaired& r, const std::string& steps) {
  EXPECT_EQ(r.refusal, "");
  EXPECT_EQ(steps_of(r), steps);
  EXPECT_TRUE(check_solid(r.mesh).empty()) << summarize(check_solid(r.mesh));
  EXPECT_NEAR(enclosed_volume(r.mesh), 1.0, 1e-12);
}

TEST(Repair, leaves_a_sound_mesh_unchanged) {
  for (const TriangleMesh& m : {unit_box, battery::torus(2, 0.5, 24, 12), battery::sphere(1, 2)}) {
    const Repaired r = repair(m);
    EXPECT_TRUE(r.steps.empty());
    EXPECT_EQ(r.mesh.positions, m.positions);
    EXPECT_EQ(r.mesh.triangles, m.triangles);
  }
}

/// Neither a point that no facet has nor two at one place makes a mesh unsound.
TEST(Repair, of_a_sound_mesh_leaves_also_what_it_need_not_have) {
  TriangleMesh m = unit_box;
  m.positions.push_back({0.5, 0.5, 3.0});
  m.positions.push_back(m.positions[0]);
  ASSERT_TRUE(check_solid(m).empty());
  const Repaired r = repair(m);
  EXPECT_EQ(steps_of(r), "");
  EXPECT_EQ(r.mesh.positions, m.positions);
}

/// On request a sound mesh is welded too, even if nothing is left of it.
TEST(Repair, welds_a_sound_mesh_on_request) {
  EXPECT_EQ(repair(unit_box, {2.0}).refusal, "no facet is left");
  EXPECT_EQ(repair(unit_box, {1.0}).refusal, "no facet is left");
  const Repaired r = repair(unit_box, {0.5});
  EXPECT_EQ(r.refusal, "");
  EXPECT_EQ(r.mesh.triangles, unit_box.triangles);
}

TEST(Repair, merges_equal_points) {
  TriangleMesh soup;
  for (const Triangle& t : unit_box.triangles) {
    const int n = static_cast<int>(soup.positions.size());
    for (const int v : t) soup.positions.push_back(unit_box.positions[static_cast<std::size_t>(v)]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  expect_box(repair(soup), "28 points merged at equal places\n");
}

TEST(Repair, welds_near_points_on_request) {
  TriangleMesh m = unit_box;
  const int corner = m.triangles[0][0];
  m.positions.push_back(m.positions[static_cast<std::size_t>(corner)] + Vec3(1e-7, 0, 0));
  m.triangles[0][0] = static_cast<int>(m.positions.size()) - 1;
  expect_box(repair(m, {1e-6}), "1 points merged with another within 0.001 mm\n");
}

TEST(Repair, flips_facets_that_disagree) {
  TriangleMesh m = unit_box;
  turn(m, 3);
  turn(m, 8);
  expect_box(repair(m), "2 facets flipped to agree with their neighbours\n");
}

TEST(Repair, flips_a_mesh_that_is_inside_out) {
  TriangleMesh m = unit_box;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) turn(m, i);
  expect_box(repair(m), "12 facets flipped to orient pieces outwards\n");
}

TEST(Repair, fills_holes) {
  TriangleMesh m = unit_box;
  m.triangles.erase(m.triangles.begin() + 2);
  m.triangles.pop_back();
  const Repaired r = repair(m);
  ASSERT_FALSE(r.steps.empty()) << r.refusal;
  expect_box(r, r.steps.at(0).count == 2 ? "2 holes filled\n" : "1 holes filled\n");
}

TEST(Repair, drops_duplicate_facets_and_pairs_that_face_each_other) {
  TriangleMesh m = unit_box;
  m.triangles.push_back(m.triangles[5]);
  m.positions.push_back({0.5, 0.5, 3.0});
  m.triangles.push_back({0, 1, 8});
  m.triangles.push_back({1, 0, 8});
  expect_box(repair(m), "3 duplicate facets dropped\n1 unused points dropped\n");
}

TEST(Repair, drops_protruding_sheets) {
  TriangleMesh m = unit_box;
  m.positions.push_back({0.5, 0.5, 3.0});
  m.triangles.push_back({m.triangles[0][0], m.triangles[0][1], 8});
  expect_box(repair(m), "1 facets of protruding sheets dropped\n1 unused points dropped\n");
}

/// A box with a point on a side of its first facet, and the flat facet that closes the seam, beginning with any corner.
TriangleMesh box_with_flat_facet(double along, std::size_t first) {
  TriangleMesh m = unit_box;
  const Triangle t = m.triangles[0];
  const auto x = [&](std::size_t k) { return m.positions[static_cast<std::size_t>(t[k])]; };
  m.positions.push_back((1.0 - along) * x(0) + along * x(1));
  m.triangles[0] = {t[0], 8, t[2]};
  m.triangles.push_back({8, t[1], t[2]});
  Triangle flat{t[0], t[1], 8};
  std::rotate(flat.begin(), flat.begin() + static_cast<std::ptrdiff_t>(first), flat.end());
  m.triangles.push_back(flat);
  return m;
}

TEST(Inspect, counts_facets_without_area) {
  EXPECT_EQ(inspect(unit_box).degenerate, 0u);
  TriangleMesh m = box_with_flat_facet(0.5, 0);
  EXPECT_EQ(inspect(m).degenerate, 1u);
  m.triangles.push_back(m.triangles.back());
  EXPECT_EQ(inspect(m).degenerate, 2u);
  m.positions.back() += 1e-6 * Vec3::Ones();  // flat no more, but thin
  EXPECT_EQ(inspect(m).degenerate, 0u);
}

TEST(Repair, removes_facets_without_area) {
  for (const double along : {0.25, 0.5, 0.75})
    for (const std::size_t first : {0u, 1u, 2u}) {
      const TriangleMesh m = box_with_flat_facet(along, first);
      EXPECT_EQ(check_closed(m).size(), 1u);
      expect_box(repair(m), "1 facets without area removed\n");
    }
}

/// There splitting facets only makes others without area.
TEST(Repair, gives_up_on_a_solid_squeezed_into_a_line) {
  TriangleMesh m = unit_box;
  for (Vec3& x : m.positions) x = Vec3(x.x() + 2.0 * x.y() + 4.0 * x.z(), 0.0, 0.0);
  const Repaired r = repair(m);
  EXPECT_NE(r.refusal, "") << steps_of(r);
}

/// Two boxes that share an edge, as one mesh: four facets meet there.
TEST(Repair, separates_solids_that_share_an_edge) {
  const TriangleMesh two = joined(unit_box, battery::box({1, 1, 0}, {2, 2, 1}));
  const TriangleMesh m{two.positions, merge_equal_vertices(two)};
  ASSERT_EQ(inspect(m).non_manifold_edges, 1u);
  const Repaired r = repair(m);
  EXPECT_EQ(r.refusal, "");
  EXPECT_TRUE(check_solid(r.mesh).empty()) << summarize(check_solid(r.mesh));
  EXPECT_EQ(inspect(r.mesh).pieces, 2u);
  EXPECT_DOUBLE_EQ(enclosed_volume(r.mesh), 2.0);
}

TEST(Repair, keeps_a_cavity) {
  TriangleMesh cavity = battery::box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
  for (std::size_t i = 0; i < cavity.triangles.size(); ++i) turn(cavity, i);
  TriangleMesh broken = joined(unit_box, cavity);
  turn(broken, 0);
  const Repaired r = repair(broken);
  EXPECT_EQ(r.refusal, "");
  EXPECT_DOUBLE_EQ(enclosed_volume(r.mesh), 1.0 - 0.25 * 0.25 * 0.25);
}

TEST(Repair, unites_pieces_that_overlap) {
  const TriangleMesh m = joined(unit_box, battery::box({0.5, 0.25, 0.25}, {2, 0.75, 0.75}));
  ASSERT_GT(inspect(m).intersecting_pairs, 0u);
  const Repaired r = repair(m);
  EXPECT_EQ(r.refusal, "");
  EXPECT_TRUE(check_solid(r.mesh).empty());
  EXPECT_NEAR(enclosed_volume(r.mesh), 1.0 + 1.0 * 0.25, 1e-12);
}

/// A vertex moved past its neighbours: the surface folds over itself in one place.
TEST(Repair, remeshes_where_a_surface_crosses_itself) {
  const TriangleMesh whole = battery::sphere(1, 3);
  TriangleMesh m = whole;
  const Vec3 out = whole.positions[0], along = out.cross(Vec3::UnitZ()).normalized();
  m.positions[0] = 0.97 * out + 0.3 * along;
  ASSERT_FALSE(self_intersections(m).empty());
  const Repaired r = repair(m);
  EXPECT_EQ(r.refusal, "");
  EXPECT_NE(steps_of(r).find("by uniting pieces or remeshing"), std::string::npos) << steps_of(r);
  EXPECT_TRUE(check_solid(r.mesh).empty());
  constexpr double patch = 5e-4;  // of the volume: the facets around a vertex
  EXPECT_NEAR(enclosed_volume(r.mesh) / enclosed_volume(whole), 1.0, patch);
}

TEST(Repair, rejects_an_odd_edge) {
  TriangleMesh m = joined(unit_box, battery::box({1, 0, 0}, {2, 1, 1}));
  m.triangles = merge_equal_vertices(m);
  std::vector<Triangle> wall;  // one of the two facing walls between the boxes
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const Triangle& t = m.triangles[i];
    const bool on_wall = std::all_of(t.begin(), t.end(), [&](int v) {
      return m.positions[static_cast<std::size_t>(v)].x() == 1.0;
    });
    if (!on_wall || i < 12) wall.push_back(t);
  }
  m.triangles = wall;
  EXPECT_NE(repair(m).refusal.find("3 facets meet at an edge of triangle "), std::string::npos)
      << repair(m).refusal;
  for (const RepairStep& step : repair(m).steps)  // what was rejected is not reported as done
    EXPECT_EQ(step.what.find("more than two facets"), std::string::npos) << step.what;
}

TEST(Repair, rejects_a_one_sided_surface) {
  TriangleMesh strip;
  constexpr int n = 12;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    const Vec3 across = 0.3 * (std::cos(a / 2) * out + std::sin(a / 2) * Vec3::UnitZ());
    strip.positions.push_back(out + across);
    strip.positions.push_back(out - across);
  }
  for (int i = 0; i < n; ++i) {
    const bool last = i == n - 1;
    const int a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    strip.triangles.push_back({a, b, d});
    strip.triangles.push_back({a, d, c});
  }
  EXPECT_NE(repair(strip).refusal.find("is one-sided"), std::string::npos) << repair(strip).refusal;
}

/// Any mixture of repairable damage: the solid comes back, and a second repair changes nothing.
RC_GTEST_PROP(Repair, repairs_random_damage, ()) {
  TriangleMesh m = *rc::gen::arbitrary<bool>() ? battery::sphere(1, 1) : battery::cylinder(1, 2, 9);
  const double volume = enclosed_volume(m);
  const std::size_t n = m.triangles.size();
  const int flips = *rc::gen::inRange(0, 6);
  for (int k = 0; k < flips; ++k) turn(m, *rc::gen::inRange<std::size_t>(0, n));
  const int copies = *rc::gen::inRange(0, 3);
  for (int k = 0; k < copies; ++k)
    m.triangles.push_back(m.triangles[*rc::gen::inRange<std::size_t>(0, n)]);
  if (*rc::gen::arbitrary<bool>()) {
    const int v = m.triangles[0][0];
    m.positions.push_back(Vec3(m.positions[static_cast<std::size_t>(v)]));
    m.triangles[0][0] = static_cast<int>(m.positions.size()) - 1;
  }
  const Repaired r = repair(m);
  RC_ASSERT(r.refusal.empty());
  RC_ASSERT(check_solid(r.mesh).empty());
  RC_ASSERT(std::abs(enclosed_volume(r.mesh) - volume) <= 1e-12 * volume);
  RC_ASSERT(repair(r.mesh).steps.empty());
}

/// A sphere whose points move in any direction. Along their radii alone they would never make it cross itself.
RC_GTEST_PROP(SelfIntersections, are_those_of_the_twin, ()) {
  TriangleMesh m = battery::sphere(1, 1);
  const int size = *rc::gen::inRange(0, 60);
  for (Vec3& x : m.positions)
    for (Eigen::Index k = 0; k < 3; ++k) x[k] += 0.01 * *rc::gen::inRange(-size, size + 1);
  const auto found = self_intersections(m), twin = reference::self_intersections(m);
  RC_CLASSIFY(!twin.empty());
  RC_ASSERT(found == twin);
}

TEST(SelfIntersections, of_a_crumpled_sphere_are_many) {
  TriangleMesh m = battery::sphere(1, 1);
  for (std::size_t v = 0; v < m.positions.size(); v += 3) m.positions[v] *= -0.7;
  const auto found = self_intersections(m);
  EXPECT_GT(found.size(), 20u);
  EXPECT_EQ(found, reference::self_intersections(m));
}

TEST(SelfIntersections, of_solids_that_touch_are_none) {
  EXPECT_TRUE(self_intersections(joined(unit_box, battery::box({1, 1, 0}, {2, 2, 1}))).empty());
  EXPECT_FALSE(self_intersections(joined(unit_box, unit_box)).empty());
}

TEST(Inspect, counts_what_is_wrong) {
  TriangleMesh m = unit_box;
  turn(m, 3);
  m.triangles.push_back(m.triangles[5]);
  m.positions.push_back(Vec3(m.positions[0]));
  const Inspection i = inspect(m);
  EXPECT_EQ(i.equal_points, 1u);
  EXPECT_EQ(i.duplicates, 1u);
  EXPECT_EQ(i.flipped_edges + i.non_manifold_edges, 6u);
  EXPECT_FALSE(i.is_oriented());
  EXPECT_EQ(inspect(m).box.lo, bounding_box(m).lo);
  EXPECT_EQ(inspect(m).box.hi, bounding_box(m).hi);
  EXPECT_DOUBLE_EQ(inspect(unit_box).longest_edge, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(inspect(unit_box).shortest_edge, 1.0);
  EXPECT_DOUBLE_EQ(inspect(unit_box).mean_edge, (12.0 + 6.0 * std::sqrt(2.0)) / 18.0);
  EXPECT_DOUBLE_EQ(inspect(unit_box).volume, 1.0);
}

TEST(MeshFaults, report_what_where_how_many_and_the_command) {
  TriangleMesh m = unit_box;
  turn(m, 3);
  m.triangles.pop_back();
  const auto lines = mesh_faults("a b/c.stl", {{"tool", m}, {"fine", unit_box}});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].rfind("a b/c.stl: solid tool: hole: 3 times, first edge ", 0), 0u) << lines[0];
  EXPECT_EQ(lines[1].rfind("a b/c.stl: solid tool: flipped triangle: 3 times, first edge ", 0), 0u)
      << lines[1];
  EXPECT_EQ(lines[2],
            "a b/c.stl: to repair: tdbd mesh 'a b/c.stl' --repair -o 'a b/c-repaired.stl'");
}

/// A fan of facets, open all around.
TriangleMesh open_fan(int corners) {
  TriangleMesh m;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    m.positions.emplace_back(std::cos(angle), std::sin(angle), std::sin(7.0 * k));
    if (k > 1) m.triangles.push_back({0, k - 1, k});
  }
  return m;
}

/// Filling its hole took 20 s, for the message's sake.
TEST(MeshFaults, do_not_try_the_repair_of_a_hole_of_thousands_of_edges) {
  const std::string repair = "tdbd mesh a.off --repair -o a-repaired.off";
  EXPECT_EQ(mesh_faults("a.off", {{"fan", open_fan(1001)}}).back(),
            "a.off: to try a repair: " + repair);
  EXPECT_NE(mesh_faults("a.off", {{"fan", open_fan(100)}}).back().find("the hole of 100 edges at "),
            std::string::npos);
}

}  // namespace tdbd::mesh::repair_test
