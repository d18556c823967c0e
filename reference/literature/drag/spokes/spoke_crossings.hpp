#pragma once

#include "reference/literature/drag/spokes/spoke_cutter.hpp"

namespace tdbd::reference {

/// A tip passes through the half-plane of a spoke.
struct SpokeCrossing {
  double share = 0.0;  ///< fraction of the step's motion, in (0, 1]
  std::size_t cutter = 0;
  int spoke = 0;
  bool forward = true;  ///< whether the azimuth increases
};

/// Positions of the tips of a bit relative to the spokes. Its arrays are reused from step to step.
struct SpokeTracker {
  int spokes = 0;
  std::vector<double> at;  ///< azimuth of each tip in spokes, unwrapped. The end of one step is
                           ///< bitwise the start of the next, so no crossing is lost or found twice
  std::vector<SpokeCrossing> crossings;  ///< of the last step, in order of time
};

SpokeTracker spoke_tracker(const std::vector<SpokeCutter>& cutters, const BitPlace& start,
                           int spokes);

/// Advances to the end of a step and lists its crossings. Azimuths must change uniformly within a
/// step and by less than half a turn.
void track(SpokeTracker& tracker, const std::vector<SpokeCutter>& cutters, const BitPlace& end);

/// Index of a spoke (0 to spokes - 1) from an unwrapped one.
int spoke_number(double unwrapped, int spokes);

/// The next spoke that a tip with this velocity (W) reaches.
int spoke_ahead(const PlacedCutter& c, const Vec3& v_W, int spokes);

}  // namespace tdbd::reference
