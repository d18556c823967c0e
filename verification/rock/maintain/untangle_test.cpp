#include "rock/maintain/untangle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/tolerance.hpp"
#include "mesh/edit.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/intersections.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/start/borehole.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"
#include "verification/rock/bumpy_sheet.hpp"
#include "verification/rock/maintain/bare_limits.hpp"

namespace tdbd::rock::untangle_test {

constexpr double edge = 0.3;

std::size_t pairs_in(const Rock& rock) {
  return reference::self_intersecting_pairs(mesh::compact(rock.surface));
}

constexpr int middle = 5 * 11 + 5;

/// An uneven sheet of which one vertex was carried past its neighbours, by 1 to 1.6 edges along the
/// sheet and up to a fifth out of it: what a part does to rock that it takes along a wall by more
/// than an edge at once.
mesh::TriangleMesh tangled_mesh(std::uint64_t seed) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.2, seed);
  const double turn = 2.399963 * static_cast<double>(seed);  // the golden angle: all directions
  const double far = edge * (1.0 + 0.1 * static_cast<double>(seed % 7));
  const double out = 0.1 * edge * static_cast<double>(static_cast<int>(seed % 5) - 2);
  m.positions[middle] += Vec3(far * std::cos(turn), far * std::sin(turn), out);
  return m;
}

/// As rock, what changed being touched.
Rock tangled(const mesh::TriangleMesh& m) {
  Rock rock = rock_of(m);
  touch(rock, middle);
  mark_neighbours_changed(rock, middle);
  return rock;
}

Rock tangled(std::uint64_t seed) { return tangled(tangled_mesh(seed)); }

MaintenanceLimits limits() {
  MaintenanceLimits l = bare_limits_for(edge);
  l.flip_quality = 0.6;
  l.smoothing = Smoothing::tangential;
  l.smooth_quality = 0.5;
  return l;
}

struct Outcome {
  std::size_t tangled = 0, left = 0;  ///< scenes with pairs, before and after maintenance
  std::string broken;
};

Outcome maintain_all(const MaintenanceLimits& l) {
  Outcome outcome;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Rock before = tangled(seed);
    Rock rock = before;
    MaintenanceWorkspace work;
    MaintenanceReport report;
    maintain(rock, l, work, report);
    outcome.tangled += pairs_in(before) > 0 ? 1U : 0U;
    outcome.left += pairs_in(rock) > 0 ? 1U : 0U;
    outcome.broken += describe(check_maintenance(before, rock, l, report, work.drift), 1);
  }
  return outcome;
}

/// Of 200 scenes; with the promises M1 to M3 and M5 to M7.
TEST(Untangle, parts_layers_that_pass_through_each_other) {
  MaintenanceLimits without = limits();
  without.untangle_farthest = 0.0;
  const Outcome off = maintain_all(without), on = maintain_all(limits());
  fmt::print("of {} tangled scenes {} stay so without untangling, {} with it\n", on.tangled,
             off.left, on.left);
  EXPECT_GT(on.tangled, 40U);
  EXPECT_GT(off.left, 20U);
  EXPECT_EQ(on.left, 0U);
  EXPECT_EQ(on.broken, "");
}

/// The vertices that untangling removed.
std::vector<int> removed_from(const mesh::TriangleMesh& m) {
  Rock rock = tangled(m);
  MaintenanceLimits l = limits();
  l.flip_quality = 0.0;
  l.smoothing = Smoothing::off;
  MaintenanceWorkspace work;
  MaintenanceReport report;
  maintain(rock, l, work, report);
  if (report.carried_out(Operation::untangling) == 0) return {};
  std::vector<int> removed;
  for (int v = 0; v < static_cast<int>(m.positions.size()); ++v)
    if (!rock.surface.is_alive(v)) removed.push_back(v);
  return removed;
}

/// Triangles near the middle, each with each corner, come first in turn: corner 0 is a corner like others.
TEST(Untangle, does_not_depend_on_which_corner_comes_first) {
  int asked = 0;
  for (std::uint64_t seed = 0; asked < 4; ++seed) {
    const mesh::TriangleMesh m = tangled_mesh(seed);
    const std::vector<int> removed = removed_from(m);
    if (removed.empty()) continue;
    ++asked;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      if ((mesh::corners(m, t)[0] - m.positions[middle]).norm() > 3.0 * edge) continue;
      for (std::ptrdiff_t k = 0; k < 3; ++k) {
        mesh::TriangleMesh other = m;
        std::rotate(other.triangles[t].begin(), other.triangles[t].begin() + k,
                    other.triangles[t].end());
        std::swap(other.triangles[0], other.triangles[t]);
        EXPECT_EQ(removed_from(other), removed) << seed << " " << t << " " << k;
      }
    }
  }
}

/// Where no place is near enough, the refusals say so, by name.
TEST(Untangle, counts_why_it_is_rejected) {
  MaintenanceLimits l = limits();
  l.untangle_farthest = 1e-9;  // m: no collapse moves so little
  MaintenanceReport report;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rock rock = tangled(seed);
    MaintenanceWorkspace work;
    maintain(rock, l, work, report);
  }
  const auto& why = report.refused[static_cast<std::size_t>(Operation::untangling)];
  EXPECT_GT(why[static_cast<std::size_t>(Refusal::distance)], 5);
  EXPECT_EQ(why[static_cast<std::size_t>(Refusal::intersection)], 0);
  EXPECT_EQ(report.carried_out(Operation::untangling), 0);
}

using Pairs = std::vector<std::pair<int, int>>;

double longest_edge(const mesh::Surface& s) {
  double longest = 0.0;
  for (const auto& [a, b, c] : s.triangles)
    for (const auto& [v, w] : {std::pair{a, b}, {b, c}, {c, a}})
      longest = std::max(longest, (s.position(v) - s.position(w)).norm());
  return longest;
}

/// Triangles by their corners.
std::pair<mesh::Triangle, mesh::Triangle> by_corners(mesh::Triangle s, mesh::Triangle t) {
  std::sort(s.begin(), s.end());
  std::sort(t.begin(), t.end());
  return std::minmax(s, t);
}

using ByCorners = std::set<std::pair<mesh::Triangle, mesh::Triangle>>;

ByCorners reference_pairs(const mesh::Surface& s) {
  ByCorners pairs;
  for (const auto& [t, u] : reference::self_intersections({mesh::positions_of(s), s.triangles}))
    pairs.insert(by_corners(s.triangles[t], s.triangles[u]));
  return pairs;
}

ByCorners pairs_of(const Rock& rock, const Patch& patch) {
  IntersectionWork work;
  find_intersections(rock, patch, longest_edge(rock.surface), 1'000'000, work);
  ByCorners pairs;
  for (const auto& [t, u] : work.met) pairs.insert(by_corners(t, u));
  return pairs;
}

/// Triangle by triangle: what CGAL finds in the whole mesh.
RC_GTEST_PROP(Intersections, are_those_of_cgal, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.3, 1.2)));
  const mesh::Surface& s = rock.surface;
  ByCorners found;
  Patch patch;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    take_triangle(s, t, patch);
    found.merge(pairs_of(rock, patch));
  }
  RC_TAG(found.empty() ? "none" : "some");
  RC_ASSERT(found == reference_pairs(s));
}

/// The pairs in which a triangle of the stars is.
RC_GTEST_PROP(Intersections, of_stars_are_those_of_their_triangles, ()) {
  const Rock rock = rock_of(any_sheet(1.0));
  const mesh::Surface& s = rock.surface;
  const std::vector<int> vertices{*battery::integer(0, s.vertex_slots() - 1),
                                  *battery::integer(0, s.vertex_slots() - 1)};
  const auto has_one = [&](const mesh::Triangle& t) {
    return std::ranges::any_of(t, [&](int v) { return std::ranges::count(vertices, v) > 0; });
  };
  ByCorners expected = reference_pairs(s);
  std::erase_if(expected,
                [&](const auto& pair) { return !has_one(pair.first) && !has_one(pair.second); });
  Patch patch;
  take_stars(s, vertices, patch);
  RC_ASSERT(pairs_of(rock, patch) == expected);
}

}  // namespace tdbd::rock::untangle_test

namespace tdbd::rock::trim_test {

using mesh::Surface;

/// A hole of radius 1 and a wall of 1 above its flat bottom at z = 0; inner vertices left their
/// places by up to `bump` m.
Rock hole(double bump) {
  mesh::TriangleMesh m = borehole(flat_bottom(1.0, 0.0, 1.0), *battery::number(0.12, 0.3));
  Surface s = mesh::make_surface(m);
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (!s.is_boundary(v)) s.place(v, s.position(v) + bump * *battery::direction());
  const mesh::Box box = mesh::bounding_box(mesh::compact(s));
  return make_rock(std::move(s), 0.3, box);
}

bool is_above(const Surface& s, int t, double z) {
  return std::ranges::all_of(s.triangles[static_cast<std::size_t>(t)],
                             [&](int v) { return s.position(v).z() < z; });
}

long triangles_above(const Surface& s, double z) {
  long n = 0;
  for (int t = 0; t < s.triangle_slots(); ++t) n += s.triangle_is_alive(t) && is_above(s, t, z);
  return n;
}

double volume(const Rock& rock) { return mesh::hole_volume(rock.surface, Vec3::Zero()); }

/// M1, with one boundary loop; what is not above the plane has the same bits.
RC_GTEST_PROP(Trim, leaves_a_disc_and_the_rest_alone, ()) {
  Rock rock = hole(0.03);
  const Surface before = rock.surface;
  const double z = *battery::number(-1.1, 0.1);
  TrimWorkspace work;
  TrimReport report;
  trim_wall(rock, -1e300, z, work, report);
  RC_ASSERT(describe(check_disc(rock)) == "");
  RC_ASSERT(report.triangles == before.triangle_count() - rock.surface.triangle_count());
  for (int t = 0; t < before.triangle_slots(); ++t) {
    RC_ASSERT(rock.surface.triangle_is_alive(t) || is_above(before, t, z));
    if (rock.surface.triangle_is_alive(t))
      RC_ASSERT(rock.surface.triangles[static_cast<std::size_t>(t)] ==
                before.triangles[static_cast<std::size_t>(t)]);
  }
  for (int v = 0; v < before.vertex_slots(); ++v)
    if (rock.surface.is_alive(v)) RC_ASSERT(rock.surface.position(v) == before.position(v));
  RC_ASSERT(report.triangles > 0 || z < -0.6);  // below an edge or two there is nothing to take
}

/// All of a plain wall above the plane goes.
RC_GTEST_PROP(Trim, takes_all_that_is_above_the_plane, ()) {
  Rock rock = hole(0.0);
  const double z = *battery::number(-0.95, -0.05);
  TrimWorkspace work;
  TrimReport report;
  trim_wall(rock, -1e300, z, work, report);
  RC_ASSERT(report.triangles > 0 || z < -0.6);
  RC_ASSERT(triangles_above(rock.surface, z) == 0);
}

RC_GTEST_PROP(Trim, accounts_for_the_volume, ()) {
  Rock rock = hole(0.03);
  const double before = volume(rock);
  TrimWorkspace work;
  TrimReport report;
  trim_wall(rock, -1e300, *battery::number(-1.0, 0.1), work, report);
  RC_ASSERT(std::abs(volume(rock) + report.volume - before) < tolerance::ledger * 27.0);
}

/// Step by step, looking at the last two edge lengths only, ends where one trim ends.
RC_GTEST_PROP(Trim, may_continue_from_the_last_plane, ()) {
  Rock once = hole(0.0), often = once;
  TrimWorkspace work;
  TrimReport report_once, report_often;
  double last = -1e300;
  for (const double z : {-0.8, -0.55, -0.3}) {
    trim_wall(often, last - 0.9, z, work, report_often);
    last = z;
  }
  trim_wall(once, -1e300, last, work, report_once);
  RC_ASSERT(report_often.triangles == report_once.triangles);
  RC_ASSERT(once.surface.triangles == often.surface.triangles);
}

/// The slots of what went serve the next bisections.
TEST(Trim, gives_its_slots_back) {
  const mesh::TriangleMesh m = borehole(flat_bottom(1.0, 0.0, 1.0), 0.2);
  Rock rock = make_rock(mesh::make_surface(m), 0.3, mesh::bounding_box(m));
  TrimWorkspace work;
  TrimReport report;
  trim_wall(rock, -1e300, -0.5, work, report);
  ASSERT_GT(report.triangles, 10);
  const int slots = rock.surface.triangle_slots(), vertices = rock.surface.vertex_slots();
  EXPECT_EQ(slots - rock.surface.triangle_count(), report.triangles);
  for (int k = 0; k < 5; ++k) {
    int c = 0;
    while (!rock.surface.triangle_is_alive(c / 3) || rock.surface.opposite_of(c) < 0) ++c;
    mesh::split_edge(rock.surface, c, rock.surface.position(rock.surface.vertex(c)));
  }
  EXPECT_EQ(rock.surface.triangle_slots(), slots);
  EXPECT_EQ(rock.surface.vertex_slots(), vertices);
}

}  // namespace tdbd::rock::trim_test
