#pragma once

#include "dynamics/rotation_state.hpp"
#include "simulation/checkpoint/tape_items.hpp"

// The members of a RotationState, in the order in which a checkpoint holds them.

namespace tdbd::simulation {

template <class A>
void fields(A& a, Of<A, dynamics::RotationState>& x) {
  a("q_WB", x.q_WB);
  a("momentum_W", x.momentum_W);
  a("cone_angles", x.cone_angles);
  a("cone_momenta", x.cone_momenta);
  a("turns", x.turns);
  a("time", x.time);
}

}  // namespace tdbd::simulation
