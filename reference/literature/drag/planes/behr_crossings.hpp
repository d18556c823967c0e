#pragma once

#include "reference/literature/drag/planes/behr.hpp"

namespace tdbd::reference {

/// The straight path of a bit in one sub-step.
struct BehrSegment {
  BitPlace from, to;
  double dt = 0.0;  ///< s

  BitPlace at(double share) const { return between(from, to, share); }
};

/// Horizontal velocity of the tip of a rim, m/s.
Vec3 tip_velocity(const BehrSegment& way, const BitPlace& place, const CutterRim& rim);

/// Fills state.crossings, and updates the tips' azimuths to the end of the segment.
void find_crossings(BehrState& state, const BehrSegment& way);

/// Cuts at one crossing. Returns the cut, and adds the removed volume, m3.
BehrCut cut_at(BehrState& state, const BehrSegment& way, const BehrCrossing& crossing,
               double& volume);

}  // namespace tdbd::reference
