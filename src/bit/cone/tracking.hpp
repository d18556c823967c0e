#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/tooth_prints.hpp"

namespace tdbd::bit {

/// What counts as tracking, and how long the bit is looked at.
struct TrackingOptions {
  double penetration = 5e-3;     ///< m, of a print: its width
  double share_of_width = 0.25;  ///< a print tracks if an earlier one is closer than this
  int revolutions = 20;          ///< of the bit, whose prints are judged
  int lags = 1;                  ///< revolutions back to which they are compared, one by one
};

/// How often teeth fall into earlier prints (thesis 1.2: "tracking").
struct TrackingShare {
  long prints = 0;            ///< judged
  std::vector<double> share;  ///< [lag - 1]: tracked prints over all
  double random_phase = 0.0;  ///< the same if the phase to the last revolution were random
};

/// Rings on one bottom. A print tracks at lag k if a print of any ring, made between k - 1 and k
/// revolutions earlier, lies closer than `share_of_width` times its own width. Its random-phase
/// value is the share of its ring that such places cover for the last revolution: what an unknown
/// phase of the earlier pattern gives on average. `speed_ratios`: of each ring's cone over the bit,
/// > 0. Rolls without a start: earlier prints are there at once. One result for each ring. [+]
std::vector<TrackingShare> tracking(const std::vector<PrintRing>& rings,
                                    const std::vector<double>& speed_ratios,
                                    const TrackingOptions& options);

/// Shares of several rings together, weighed by their prints.
TrackingShare combined(const std::vector<TrackingShare>& rings);

/// A row of a bit, its ring and its cone's place in Bit::cones.
struct BitRow {
  int cone = 0;
  int row = 0;  ///< in ConeLayout::rows
  PrintRing ring;
};

/// All rows of all cones whose teeth let go of the bottom, in the bit's order.
std::vector<BitRow> bit_rows(const Bit& bit, double penetration);

/// tracking of the rows of a bit whose cones turn at these speeds over the bit's.
std::vector<TrackingShare> tracking(const std::vector<BitRow>& rows,
                                    const std::vector<double>& cone_speeds,
                                    const TrackingOptions& options);

}  // namespace tdbd::bit
