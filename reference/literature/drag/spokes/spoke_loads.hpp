#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// What a crossing does to the bit, turning with it, and for how long: until its tip, with the speed that it has, would
/// be at the next spoke.
struct SpokeLoad {
  Vec3 force_B = Vec3::Zero();  ///< N
  double torque = 0.0;          ///< N m, about the bit's axis
  double time = 0.0;            ///< s
};

/// N, N m: weight and torque that a bit needs against its cutters' loads.
struct NeededLoad {
  double wob = 0.0, tob = 0.0;
};

/// The loads of a led bit's cutters in one step, which models on spokes know only at crossings.
struct SpokeLoads {
  double step = 0.0;            ///< s
  std::vector<SpokeLoad> last;  ///< of each cutter; `time`: what is left of it
  std::vector<double> since;    ///< s of the step for which each cutter's load was counted
  std::vector<Vec3> force_B;    ///< N, of each cutter, mean over the step
  NeededLoad spread, by_step;   ///< means over the step: of that; of all the time at once
};

SpokeLoads spoke_loads(std::size_t cutters, double step);

/// Nothing has been counted in this step yet.
void begin_step(SpokeLoads& loads);

/// A crossing at a time of the step (s). One that comes too early, as after a turn back, lets what is
/// left of the last one count at once, so that no impulse is lost.
void cross(SpokeLoads& loads, std::size_t cutter, double when, const SpokeLoad& load);

/// Counts to the end of the step.
void end_step(SpokeLoads& loads);

/// Of the last crossings, however long ago.
NeededLoad held_load(const SpokeLoads& loads);

/// Level force of all cutters, N, turning with the bit, mean over the step.
double lateral_size(const SpokeLoads& loads);

}  // namespace tdbd::reference
