#pragma once

#include "reference/literature/roller/craters/crater_drilling.hpp"

namespace tdbd::reference {

/// The two ways in which the patent of Huang and Cawthorne moves cones (thesis 2.2).
enum class PatentWay {
  first,  ///< that of Ma, Zhou and Deng; here with a mean torque, and given ratios on the first turn
  second,  ///< inertia and the forces on the cone; the thesis says that no equations are given
};

/// Huang and Cawthorne's patent, thesis 2.2. Seen there: both ways in words. Reconstructed, on a memory of
/// patents of that family: the loop over steps of the bit's angle, rock as tables of single-tooth tests
/// (depth to force and crater), craters of the table's radius at each print's deepest place. The second way
/// is taken as speeds and angles in turn, which is the first one's recursion in other variables: the two
/// differ in what is in the torque (the bearing) and in whether it is averaged, and in nothing else.
struct HuangCawthorneOptions {
  PatentWay way = PatentWay::second;
  double bearing = 0.0;            ///< N m, of the second way
  double torque_average = 10e-3;   ///< s, of the first way
  double given_revolutions = 1.0;  ///< of the first way: its cones turn at `first_ratio` so long
  double first_ratio = 1.5;        ///< cone speed over bit speed at the start
  CraterDrillingOptions drilling{.model = "Huang and Cawthorne"};  ///< all else
};

/// Bit speed (rad/s), weight (N) and step (s) stand in the schedule; a step in the bit's angle is speed
/// times step.
RollerRun huang_cawthorne(const RollerBit& bit, const ToothTable& table,
                          const RollerSchedule& schedule,
                          const HuangCawthorneOptions& options = {});

}  // namespace tdbd::reference
