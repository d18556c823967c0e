#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The ring on which the teeth of a row print the bottom: each prints where its tip is deepest.
struct PrintRing {
  double radius = 0.0;         ///< m, from the bit's axis
  double azimuth_B = 0.0;      ///< rad, of the place where teeth print, in the bit frame
  double deepest_angle = 0.0;  ///< rad about the cone's Z (K at angle 0) of a tip at that place
  std::vector<double> angles;  ///< rad, of the teeth, as in ToothRow
  double width = 0.0;          ///< m, of a print along the ring
};

/// The ring of a row. `penetration` (m): depth of the prints below the bottom; it sets their width.
PrintRing print_ring(const Cone& cone, const ToothRow& row, double penetration);

/// Extent (m, along the ring) of a tooth where it is deepest, in the plane `penetration` (m) above
/// its lowest point.
double print_width(const Cone& cone, const ToothRow& row, double penetration);

/// A tooth touches down: the bit has turned by `turned` (rad), and the print stands at `azimuth` in
/// the hole (rad; turned + azimuth_B, not wrapped).
struct Print {
  double turned = 0.0;
  double azimuth = 0.0;
};

/// All touchdowns on a ring while the bit turns from `from` to `to` (rad), by bit (14). The cone
/// rolls at `speed_ratio` > 0 times the bit's speed; both stand at angle 0 when turned = 0. Sorted
/// by `turned`. Ours.
std::vector<Print> prints(const PrintRing& ring, double speed_ratio, double from, double to);

/// Mean number of a row's teeth in contact at a penetration (m) below the lowest point of its tips,
/// bit (15); it does not depend on the spacing. Above 1, one tooth takes over before the previous
/// one lets go. Ours.
double tooth_contact_ratio(const Cone& cone, const ToothRow& row, double penetration);

/// What counts as tracking, and for how long the bit is followed.
struct TrackingOptions {
  double penetration = 5e-3;     ///< m, of a print: sets its width
  double share_of_width = 0.25;  ///< a print tracks if an earlier one is closer than this share
  int revolutions = 20;          ///< of the bit, whose prints are judged
  int lags = 1;                  ///< how many revolutions to look back, one by one
};

/// How often teeth fall into earlier prints (thesis 1.2: "tracking").
struct TrackingShare {
  long prints = 0;            ///< judged
  std::vector<double> share;  ///< [lag - 1]: tracking prints over all prints
  double random_phase = 0.0;  ///< the share expected if the phase between revolutions were random
};

/// Tracking of rings on one bottom; one result for each ring. A print tracks at lag k if a print of
/// any ring, made between k - 1 and k revolutions earlier, lies closer than `share_of_width` times
/// its own width. Its random-phase value is the share of its ring that such places cover for the
/// last revolution: what an unknown phase would give on average. `speed_ratios`: of each ring's
/// cone over the bit, > 0. There is no start-up: earlier prints exist from the beginning. Ours.
std::vector<TrackingShare> tracking(const std::vector<PrintRing>& rings,
                                    const std::vector<double>& speed_ratios,
                                    const TrackingOptions& options);

/// Shares of several rings together, weighted by their prints.
TrackingShare combined(const std::vector<TrackingShare>& rings);

/// A row of a bit with its ring, and where it is found in the bit.
struct BitRow {
  int cone = 0;  ///< index into Bit::cones
  int row = 0;   ///< index into ConeLayout::rows
  PrintRing ring;
};

/// All rows of all cones whose teeth let go of the bottom, in the bit's order.
std::vector<BitRow> bit_rows(const Bit& bit, double penetration);

/// Tracking of the rows of a bit whose cones turn at `cone_speeds` times the bit's speed.
std::vector<TrackingShare> tracking(const std::vector<BitRow>& rows,
                                    const std::vector<double>& cone_speeds,
                                    const TrackingOptions& options);

}  // namespace tdbd::bit
