#pragma once

#include "reference/literature/roller/craters/crater_drilling.hpp"

namespace tdbd::reference {

/// The two methods by which the patent of Huang and Cawthorne moves cones (thesis 2.2).
enum class PatentMethod {
  first,   ///< that of Ma, Zhou and Deng, with a mean torque and prescribed ratios in the first
           ///< turn
  second,  ///< inertia and the forces on the cone; the thesis states that no equations are given
};

/// Huang and Cawthorne's patent, thesis 2.2. Stated there: both methods in words. Reconstructed
/// from memory of patents of that family: the loop over steps of the bit's angle, rock as tables of
/// single-tooth tests (depth to force and crater), craters with the table's radius at each print's
/// deepest place. The second method is interpreted as alternating updates of speeds and angles,
/// which is the first method's recursion in other variables. The two differ only in the terms of
/// the torque (the bearing) and in whether it is averaged.
struct HuangCawthorneOptions {
  PatentMethod way = PatentMethod::second;
  double bearing = 0.0;           ///< N m, of the second way
  double torque_average = 10e-3;  ///< s, of the first way
  double prescribed_ratio_revolutions =
      1.0;                   ///< for the first method: duration with prescribed `first_ratio`
  double first_ratio = 1.5;  ///< initial ratio of cone speed to bit speed
  CraterDrillingOptions drilling{.model = "Huang and Cawthorne"};  ///< all other options
};

/// Bit speed (rad/s), weight (N) and step (s) are in the schedule. A step in the bit's angle is
/// speed times step.
RollerRun huang_cawthorne(const RollerBit& bit, const ToothTable& table,
                          const RollerSchedule& schedule,
                          const HuangCawthorneOptions& options = {});

}  // namespace tdbd::reference
