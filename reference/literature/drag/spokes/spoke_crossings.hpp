#pragma once

#include "reference/literature/drag/spokes/spoke_cutter.hpp"

namespace tdbd::reference {

/// A tip passes through the half-plane of a spoke.
struct SpokeCrossing {
  double share = 0.0;  ///< of the step's motion, in (0, 1]
  std::size_t cutter = 0;
  int spoke = 0;
  bool forward = true;  ///< azimuth rises
};

/// Where the tips of a bit stand between this many spokes. Its arrays are reused from step to step.
struct SpokeTracker {
  int spokes = 0;
  std::vector<double> at;  ///< azimuth of each tip in spokes, unwrapped: the end of one step is the
                           ///< start of the next to the bit, so no crossing is lost or seen twice
  std::vector<SpokeCrossing> crossings;  ///< of the last step, in order of time
};

SpokeTracker spoke_tracker(const std::vector<SpokeCutter>& cutters, const BitPlace& start,
                           int spokes);

/// Moves on to the end of a step and lists its crossings. Azimuths change evenly within a step and by
/// less than half a turn.
void track(SpokeTracker& tracker, const std::vector<SpokeCutter>& cutters, const BitPlace& end);

/// Number of the spoke (0 to spokes - 1) for an unwrapped one.
int spoke_number(double unwrapped, int spokes);

/// The spoke that a tip with this velocity (W) comes to next.
int spoke_ahead(const PlacedCutter& c, const Vec3& v_W, int spokes);

}  // namespace tdbd::reference
