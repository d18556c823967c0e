#include "simulation/step/cone_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/step/simulation.hpp"

namespace tdbd::simulation::cone_balance_test {

/// Without a cut every cone, the first and the last, has the spin of its own momentum:
/// phi' = pi / Ic - s . W.
TEST(ConeBalance, without_a_cut_is_the_spin_of_the_momentum) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-r.toml", {"rock.edge_length='6 mm'"});
  const dynamics::DrillingSystem& system = c.drilling.system;
  dynamics::DrillingState before = c.drilling.start;
  BitVelocity motion;
  motion.w_W = Vec3(0.3, -0.2, 11.0);
  motion.cone_speeds.assign(c.bit.cones.size(), 99.0);
  for (std::size_t k = 0; k < c.bit.cones.size(); ++k)
    before.rotation.cone_momenta[k] =
        system.gyrostat.cones[k].axial_inertia * (5.0 + static_cast<double>(k));
  const std::vector<double> spins =
      balanced_spins(c.forces, c.bit, system, before, Pose{}, 1e-3, motion, {});
  ASSERT_EQ(spins.size(), c.bit.cones.size());
  for (std::size_t k = 0; k < spins.size(); ++k)
    EXPECT_NEAR(spins[k],
                5.0 + static_cast<double>(k) - system.gyrostat.cones[k].axis_B.dot(motion.w_W),
                1e-12);
}

/// The law's torque at the spin that it leads to, however steep.
TEST(ConeBalance, gives_each_cone_the_impulse_at_the_spin_that_it_leads_to) {
  const Case c = read_case(TDBD_SOURCE_DIR "/cases/drill-bit-r.toml", {"rock.edge_length='6 mm'"});
  Simulation s = start(c);
  while (s.work.cuts.empty() && s.state.steps_done < 200) step(c, s);
  ASSERT_FALSE(s.work.cuts.empty());
  const dynamics::DrillingSystem& system = c.drilling.system;
  const dynamics::DrillingState& before = s.state.drive->state;
  const Pose X_WB = over_rock(s.state.place);
  const double dt = c.time.step;
  BitVelocity motion = s.work.velocity;
  motion.cone_speeds =
      balanced_spins(c.forces, c.bit, system, before, X_WB, dt, motion, s.work.cuts);
  for (std::size_t k = 0; k < motion.cone_speeds.size(); ++k) {
    const dynamics::Cone& cone = system.gyrostat.cones[k];
    const double momentum =
        cone.axial_inertia * (motion.cone_speeds[k] + (X_WB.R * cone.axis_B).dot(motion.w_W));
    const double torque =
        cone_torque(c.forces, c.bit, static_cast<int>(k), X_WB, motion, dt, s.work.cuts);
    const double scale = cone.axial_inertia * (1.0 + std::abs(motion.cone_speeds[k]));
    EXPECT_NEAR(momentum, before.rotation.cone_momenta[k] + dt * torque, 1e-12 * scale) << k;
  }
}

}  // namespace tdbd::simulation::cone_balance_test
