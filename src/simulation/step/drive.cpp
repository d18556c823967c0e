#include "simulation/step/drive.hpp"

#include "rotation/swing_twist.hpp"

namespace tdbd::simulation {

dynamics::Drilling start_drive(const Case& c) {
  return dynamics::start_drilling(c.drilling.system, c.drilling.start, c.drilling.chain);
}

Place place_of(const dynamics::DrillingSystem& system, const dynamics::DrillingState& state) {
  return {dynamics::bit_pose(system, state),
          rotation::twist_angle(state.rotation.q_WB, state.rotation.turns), state.rock_z};
}

BitVelocity velocity_of(const dynamics::DrillingSystem& system,
                        const dynamics::DrillingState& state) {
  const dynamics::DrillingVelocity v = dynamics::velocity(system, state);
  BitVelocity over_rock;
  over_rock.p_WB = dynamics::bit_pose(system, state).p;
  over_rock.v_W = dynamics::point_velocity(v, over_rock.p_WB - state.c_W);
  over_rock.p_WB.z() -= state.rock_z;
  over_rock.v_W.z() -= v.rock;
  over_rock.w_W = v.w_W;
  over_rock.cone_speeds = v.cone_rates;
  return over_rock;
}

dynamics::Wrench wrench_of(const dynamics::DrillingSystem& system, const BitLoads& loads,
                           const Pose& X_RB) {
  dynamics::Wrench w;
  w.force_W = loads.force_W;
  w.torque_W = loads.torque_W - (X_RB.R * system.centre_B).cross(loads.force_W);
  w.cones = loads.cone_torques;
  w.rock_force = -loads.force_W.z();
  w.cone_impulse = dynamics::ConeImpulse::at_end;
  return w;
}

void follow_cones(const dynamics::DrillingState& state, double dt, std::vector<ConeState>& cones) {
  for (std::size_t k = 0; k < cones.size(); ++k) {
    set_angle(cones[k], state.rotation.cone_angles[k]);
    cones[k].speed = cones[k].turned / dt;
  }
}

}  // namespace tdbd::simulation
