#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// Load of a crossing on the bit, rotating with it, and its duration: until its tip, with its
/// present speed, would be at the next spoke.
struct SpokeLoad {
  Vec3 force_B = Vec3::Zero();  ///< N
  double torque = 0.0;          ///< N m, about the bit's axis
  double time = 0.0;            ///< s
};

/// N, N m: weight and torque that balance the loads on a bit's cutters.
struct NeededLoad {
  double wob = 0.0, tob = 0.0;
};

/// The loads on the cutters of a bit on a prescribed path in one step. Models on spokes compute
/// loads only at crossings.
struct SpokeLoads {
  double step = 0.0;            ///< s
  std::vector<SpokeLoad> last;  ///< of each cutter; `time`: remaining duration
  std::vector<double> since;    ///< s of the step for which each cutter's load has been counted
  std::vector<Vec3> force_B;    ///< N, of each cutter, mean over the step
  NeededLoad spread, by_step;   ///< means over the step: by duration of loads; all at once
};

SpokeLoads spoke_loads(std::size_t cutters, double step);

/// Resets the counts at the beginning of a step.
void begin_step(SpokeLoads& loads);

/// Applies a crossing at a time of the step (s). If it is early, as after a reversal, what is left
/// of the last load counts at once, so that no impulse is lost.
void cross(SpokeLoads& loads, std::size_t cutter, double when, const SpokeLoad& load);

/// Counts to the end of the step.
void end_step(SpokeLoads& loads);

/// Loads of the last crossings, however long ago.
NeededLoad last_loads(const SpokeLoads& loads);

/// Horizontal force of all cutters, N, rotating with the bit, mean over the step.
double lateral_size(const SpokeLoads& loads);

}  // namespace tdbd::reference
