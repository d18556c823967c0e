#pragma once

#include "reference/literature/roller/craters/crater_drilling.hpp"

namespace tdbd::reference {

/// Ma, Zhou and Deng (1995), thesis 2.2. Seen there: the bit's speed is constant, T = Ic d2phi/dt2 turns the
/// cones, eq. (2.5) moves them, the bit's depth is found by iteration so that the vertical force is the
/// weight, teeth and bottom are discretised, nothing is said of the bottom's update. Reconstructed: reading
/// (iii) of (2.5) (cone_recursion.hpp), the friction that turns the cones, and all of the bottom: a height
/// field, from which a tooth takes the swept places of its round end once it has left them. A tooth presses
/// by the depth of its point; ToothContact::round_end discretises it.
///
/// A step: turn the bit; turn the cones by the last forces; place the teeth (ma_azar.hpp); find the depth;
/// leave craters. No axial inertia, no lateral motion, torques one step late; elastic teeth are stable while
/// dt2 k rho2/Ic < 4 (k: stiffness of the teeth along the motion).
struct MaZhouDengOptions {
  CraterDrillingOptions drilling{.model = "Ma, Zhou and Deng",
                                 .print = {.path = PrintPath::swept, .shape = CraterShape::sphere}};
};

/// Bit speed (rad/s), weight (N) and step (s) stand in the schedule.
RollerRun ma_zhou_deng(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& schedule,
                       const MaZhouDengOptions& options = {});

}  // namespace tdbd::reference
