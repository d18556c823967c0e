#include "rock/maintain/trim.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "mesh/edit.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/start/borehole.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"

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
RC_GTEST_PROP(Trim, may_go_on_from_the_last, ()) {
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
