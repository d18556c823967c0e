#pragma once

#include <cstddef>
#include <vector>

#include "reference/literature/roller/roller_bit.hpp"

/// Ma and Azar's algorithm, thesis 2.2: which tooth touches a flat bottom and when, found step by step from the
/// kinematics (ma_azar.hpp). Seen in the thesis: mean rates of turning are input. Reconstructed: the bottom, which
/// sinks with the bit, and the search for the instants of entry and exit. Unlike contact_statistics.hpp it takes
/// teeth of several pitches, and it keeps the phase between rows and cones, which turn at given speeds and are
/// therefore not independent.
namespace tdbd::reference {

struct ContactSchedule {
  std::vector<double> ratios;  ///< cone speed over bit speed, one for each cone
  double bit_speed = 0.0;      ///< rad/s
  double penetration = 0.0;    ///< m, of each row's lowest point below the bottom
  double duration = 0.0;       ///< s
  double settle = 0.0;         ///< s before means are taken
  double step = 1e-3;          ///< s; the result depends on it by rounding alone
};

/// One tooth from the instant at which it meets the bottom to that at which it leaves.
struct ToothInRock {
  std::size_t tooth = 0;           ///< in the order of place_teeth
  double entry = 0.0, exit = 0.0;  ///< s; cut off at the run's ends
};

struct ContactRun {
  std::vector<ToothInRock> contacts;  ///< by entry, then by tooth
  std::vector<double> tooth_share;    ///< of the time after `settle` that each tooth touches
  std::vector<double> count_share;    ///< [n]: of the time that n teeth touch together
  double mean = 0.0, variance = 0.0;  ///< of that number
  long steps = 0;
};

/// Throws InputError ("Ma and Azar: ..."): no cones or teeth, not one ratio for each cone, a penetration that is not
/// finite, a duration, step or bit speed that is not above 0, a `settle` outside the run, and a step in which a cone
/// turns by half a turn or more.
ContactRun contact_run(const RollerBit& bit, const ContactSchedule& schedule);

}  // namespace tdbd::reference
