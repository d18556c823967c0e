#include "rock/maintain/smooth.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/measures.hpp"
#include "rock/maintain/invariants.hpp"
#include "rock/maintain/star.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::smooth_test {

MaintenanceLimits limits() { return limits_for(0.35); }

double volume(const Rock& rock) { return mesh::hole_volume(rock.surface, Vec3::Zero()); }

/// Fig. 4.22: a Laplacian step as it is flattens bumps; its part in the plane of the vector area
/// does not change the volume at all, however bumpy the rock.
RC_GTEST_PROP(Smooth, changes_no_volume, ()) {
  Rock rock = rock_of(any_sheet(0.3));
  MaintenanceLimits l = limits();
  l.volume_per_operation = l.farthest = 1.0;
  l.sharp_cosine = -1.0;
  SurfaceDrift drift;
  MaintenanceReport report;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    const double before = volume(rock);
    try_smooth(rock, v, l, drift, report);
    RC_ASSERT(std::abs(volume(rock) - before) < 1e-14);  // of 27 m3, the cube over the sheet
  }
  RC_ASSERT(report.carried_out(Operation::smoothing) > 5);
  RC_ASSERT(std::abs(report.volume_change) < 1e-14);
}

/// On flat rock nothing is refused but what does not raise the quality, or the boundary.
RC_GTEST_PROP(Smooth, keeps_flat_rock_flat_and_makes_it_better, ()) {
  mesh::TriangleMesh m = any_sheet(0.15);  // no triangle is turned over
  for (Vec3& x : m.positions) x.z() = 0.0;
  Rock rock = rock_of(m);
  SurfaceDrift drift;
  MaintenanceReport report;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    const double before = worst_quality(rock.surface, v);
    if (try_smooth(rock, v, limits(), drift, report))
      RC_ASSERT(worst_quality(rock.surface, v) > before);
    RC_ASSERT(rock.surface.position(v).z() == 0.0);
  }
  RC_ASSERT(report.carried_out(Operation::smoothing) > 5);
  RC_ASSERT(report.volume_disturbed == 0.0);
  const auto& why = report.refused[static_cast<std::size_t>(Operation::smoothing)];
  RC_ASSERT(why[static_cast<std::size_t>(Refusal::ridge)] == 0);
  RC_ASSERT(why[static_cast<std::size_t>(Refusal::distance)] == 0);
}

/// M4 and M7 of one smoothing, with the usual limits; and the distance within its bound.
RC_GTEST_PROP(Smooth, keeps_normals_boundary_and_distance, ()) {
  Rock rock = rock_of(any_sheet(*battery::number(0.1, 0.4)));
  const MaintenanceLimits l = limits();
  int smoothed = 0;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    Rock before = rock;
    before.touched.assign(before.touched.size(), 0);
    before.touched[static_cast<std::size_t>(v)] = 1;
    SurfaceDrift drift;
    MaintenanceReport report;
    if (!try_smooth(rock, v, l, drift, report)) continue;
    ++smoothed;
    RC_ASSERT(!rock.surface.is_boundary(v));
    RC_ASSERT(describe(check_normals(before.surface, rock.surface)) == "");
    RC_ASSERT(describe(check_locality(before, rock.surface)) == "");
    RC_ASSERT(describe(check_distance(before.surface, rock.surface, l)) == "");
  }
  RC_PRE(smoothed > 0);  // most of uneven sheets' are refused
}

/// A gable roof whose ridge runs along x: its vertices would slide, but may leave the ridge.
TEST(Smooth, leaves_a_sharp_ridge_alone) {
  mesh::TriangleMesh m = battery::bumpy_rock(1.5, 10, 0.0, 7);
  for (Vec3& x : m.positions) x.z() = std::abs(x.y());
  Rock rock = rock_of(m);
  SurfaceDrift drift;
  MaintenanceReport report;
  int on_ridge = 0;
  for (int v = 0; v < rock.surface.vertex_slots(); ++v) {
    const Vec3 x = rock.surface.position(v);
    if (std::abs(x.y()) > 1e-12 || rock.surface.is_boundary(v)) continue;
    ++on_ridge;
    EXPECT_EQ(judge_smooth(rock.surface, v, limits()).refused, Refusal::ridge);
    EXPECT_FALSE(try_smooth(rock, v, limits(), drift, report));
    EXPECT_EQ(rock.surface.position(v), x);
  }
  EXPECT_EQ(on_ridge, 9);
  EXPECT_EQ(report.refused[static_cast<std::size_t>(Operation::smoothing)]
                          [static_cast<std::size_t>(Refusal::ridge)],
            9);
}

TEST(Smooth, refuses_the_boundary) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.0, 7));
  for (int v = 0; v < rock.surface.vertex_slots(); ++v)
    if (rock.surface.is_boundary(v)) {
      EXPECT_EQ(judge_smooth(rock.surface, v, limits()).refused, Refusal::boundary);
    }
}

}  // namespace tdbd::rock::smooth_test
