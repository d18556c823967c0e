#pragma once

#include <gtest/gtest.h>

#include "core/tolerance.hpp"
#include "mesh/check/check.hpp"
#include "mesh/surface.hpp"
#include "reference/mesh/self_intersections.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/penetration.hpp"

namespace tdbd::simulation {

/// The pose that a simulation has reached.
inline Pose pose_of(const Case& c, const Simulation& s) {
  return pose_at(c.motion, c.time.step * static_cast<double>(s.state.steps_done));
}

/// Steps to the end of the case; after every cut no vertex is inside the bit. Steps with
/// maintenance are not tested, because the vertices that it inserts wait for the next cut.
inline void run_out(const Case& c, Simulation& s, long ask_every = 1) {
  while (s.state.steps_done < c.time.steps) {
    step(c, s);
    const bool maintained =
        c.maintenance.every > 0 && s.state.steps_done % c.maintenance.every == 0;
    if (maintained || s.state.steps_done % ask_every != 0) continue;
    ASSERT_LE(deepest_penetration(s.state.rock, s.work.cutting, pose_of(c, s)),
              tolerance::inside * s.work.cutting.size)
        << "after step " << s.state.steps_done;
  }
}

/// What must hold after any motion: the ledger closes, the surface is a disc and does not intersect
/// itself (M1, M4, M5).
inline void expect_sound(const Simulation& s) {
  const mesh::TriangleMesh m = mesh::compact(s.state.rock.surface);
  EXPECT_LE(ledger_defect(s), tolerance::ledger);
  EXPECT_TRUE(mesh::check_surface(m).empty()) << mesh::describe(mesh::check_surface(m));
  EXPECT_EQ(reference::self_intersecting_pairs(m), 0U);
}

}  // namespace tdbd::simulation
