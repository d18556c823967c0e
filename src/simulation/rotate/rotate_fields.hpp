#pragma once

#include "simulation/checkpoint/rotation_fields.hpp"
#include "simulation/rotate/rotate_checkpoint.hpp"

// The members of a rotation, in the order in which a checkpoint holds them; of Rotating those that
// are not room. Without a line here RotateCheckpoints.go_on_to_the_bit fails.

namespace tdbd::simulation {

template <class A>
void fields(A& a, Of<A, dynamics::Torque>& x) {
  a("total_W", x.total_W);
  a("cones", x.cones);
}

template <class A>
void fields(A& a, Of<A, dynamics::Rotating>& x) {
  a("state", x.state);
  a("torque", x.torque);
  a("evaluations", x.evaluations);
}

template <class A>
void fields(A& a, Of<A, Invariants>& x) {
  a("momentum_W", x.momentum_W);
  a("cone_momenta", x.cone_momenta);
  a("energy", x.energy);
  a("energy_scale", x.energy_scale);
  a("energy_drift", x.energy_drift);
  a("momentum_drift_squared", x.momentum_drift_squared);
  a("vertical_drift", x.vertical_drift);
  a("cone_momentum_drift", x.cone_momentum_drift);
  a("quaternion_defect", x.quaternion_defect);
}

template <class A>
void fields(A& a, Of<A, RotateSimulation>& x) {
  a("rotating", x.rotating);
  a("invariants", x.invariants);
  a("steps_done", x.steps_done);
}

template <class A>
void fields(A& a, Of<A, RotateWritten>& x) {
  a("rows", x.rows);
  a("last_step", x.last_step);
}

}  // namespace tdbd::simulation
