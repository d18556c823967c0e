#pragma once

#include "reference/literature/roller/craters/crater_drilling.hpp"

namespace tdbd::reference {

/// Ma, Zhou and Deng (1995), thesis 2.2. Stated there: the bit's speed is constant, T = Ic
/// d2phi/dt2 turns the cones, eq. (2.5) advances them, the bit's depth is found by iteration so
/// that the vertical force is the weight, teeth and bottom are discretised; the update of the
/// bottom is not described. Reconstructed: reading (iii) of (2.5) (cone_recursion.hpp), the
/// friction that turns the cones, and the bottom: a height field, from which a tooth removes the
/// swept places of its round end after it has left them. The force on a tooth depends on the depth
/// of its tip; ToothContact::round_end discretises it.
///
/// A step: turn the bit; turn the cones by the last forces; place the teeth (ma_azar.hpp); find the
/// depth; make craters. No axial inertia, no lateral motion, torques delayed by one step. Elastic
/// teeth are stable if dt2 k rho2/Ic < 4 (k: stiffness of the teeth along the motion).
struct MaZhouDengOptions {
  CraterDrillingOptions drilling{.model = "Ma, Zhou and Deng",
                                 .print = {.path = PrintPath::swept, .shape = CraterShape::sphere}};
};

/// Bit speed (rad/s), weight (N) and step (s) are in the schedule.
RollerRun ma_zhou_deng(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& schedule,
                       const MaZhouDengOptions& options = {});

}  // namespace tdbd::reference
