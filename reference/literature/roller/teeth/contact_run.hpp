#pragma once

#include <cstddef>
#include <vector>

#include "reference/literature/roller/roller_bit.hpp"

/// Ma and Azar's algorithm, thesis 2.2: which tooth touches a flat bottom and when, step by step
/// from the kinematics (ma_azar.hpp). Stated in the thesis: mean rates of rotation are input.
/// Reconstructed: the bottom, which moves down with the bit, and the search for the times of entry
/// and exit. Unlike contact_statistics.hpp it allows teeth of several pitches, and it preserves the
/// phase between rows and cones, which turn at given speeds and are therefore not independent.
namespace tdbd::reference {

struct ContactSchedule {
  std::vector<double> ratios;  ///< ratio of cone speed to bit speed, one per cone
  double bit_speed = 0.0;      ///< rad/s
  double penetration = 0.0;    ///< m, of each row's lowest point below the bottom
  double duration = 0.0;       ///< s
  double settle = 0.0;         ///< s before means are taken
  double step = 1e-3;          ///< s; affects the result only by rounding
};

/// The contact of one tooth, from the time at which it meets the bottom to that at which it leaves.
struct ToothInRock {
  std::size_t tooth = 0;           ///< in the order of place_teeth
  double entry = 0.0, exit = 0.0;  ///< s; truncated at the ends of the run
};

struct ContactRun {
  std::vector<ToothInRock> contacts;  ///< sorted by entry, then by tooth
  std::vector<double> tooth_share;    ///< fraction of time after `settle` in contact, per tooth
  std::vector<double> count_share;    ///< [n]: fraction of time in which n teeth are in contact
  double mean = 0.0, variance = 0.0;  ///< of the number of teeth in contact
  long steps = 0;
};

/// Throws InputError ("Ma and Azar: ...") for no cones or teeth, not exactly one ratio per cone, a
/// penetration that is not finite, a duration, step or bit speed that is not above 0, a `settle`
/// outside the run, and a step in which a cone turns by half a turn or more.
ContactRun contact_run(const RollerBit& bit, const ContactSchedule& schedule);

}  // namespace tdbd::reference
