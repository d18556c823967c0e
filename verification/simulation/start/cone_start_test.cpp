#include <gtest/gtest.h>

#include "bit/cone/cone_bit.hpp"
#include "simulation/start/start_check.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/simulation/mesh_bit.hpp"

namespace tdbd::simulation::cone_start_test {

/// Bit R on a bottom that conforms to it.
Case conforming(const std::string& time) {
  return read_case(
      write_case(test_folder(), TDBD_SOURCE_DIR "/cases/bits/bit-r.toml",
                 "shape = \"conforming\"\nedge_length = \"3 mm\"\nwall = \"15 mm\"", time),
      {"motion.cone_speeds=[1.4, 1.45, 1.5]", "motion.rate_of_penetration=0"});
}

/// A place of the bit, moved by `up` against z and by `out` from the axis, m.
Vec3 moved(const Vec3& x_B, double up, double out) {
  const double r = x_B.head<2>().norm();
  const double factor = r > 0.0 ? std::max(0.0, r + out) / r : 1.0;
  return {factor * x_B.x(), factor * x_B.y(), x_B.z() - up};
}

/// In the open, or within `slack` of it: up, and to one side where a flank is steep.
bool is_free(const mesh::Surface& rock, const Vec3& x_B, double slack) {
  for (const double out : {0.0, -slack, slack})
    if (rock_height_above(rock, moved(x_B, slack, out)) == 0.0) return true;
  return false;
}

/// However the cones stand, no tooth reaches farther into the rock than its edges cut corners.
TEST(ConeStart, a_conforming_bottom_contains_no_tooth_at_any_angle) {
  const Case c = conforming("step = \"2 ms\"\nduration = \"4 ms\"");
  const Simulation s = start(c);
  constexpr double slack = 0.5e-3;  // m: a sixth of an edge
  for (const double angle : {0.0, 0.2, 1.1, 2.9}) {
    const bit::Bit there = bit::turned(c.bit, {angle, -2 * angle, 3 * angle});
    for (const bit::Part& part : there.parts) {
      if (part.cutting == bit::Cutting::never) continue;
      for (std::size_t i = 0; i < part.mesh_P.positions.size(); i += 7)
        EXPECT_TRUE(is_free(s.state.rock.surface, part.X_BP * part.mesh_P.positions[i], slack))
            << part.name;
    }
  }
}

/// Turning in its own hole without advance it takes almost nothing; half a millimetre of the
/// bottom would be 18 cm3.
TEST(ConeStart, a_bit_that_turns_in_its_conforming_hole_takes_almost_nothing) {
  const Case c = conforming("step = \"4 ms\"\nduration = \"0.5 s\"");
  Simulation s = start(c);
  while (s.state.steps_done < c.time.steps) step(c, s);
  EXPECT_LT(s.state.ledger.removed.value(), 5.4e-8);
  EXPECT_LE(ledger_defect(s), 1e-12);
}

}  // namespace tdbd::simulation::cone_start_test
