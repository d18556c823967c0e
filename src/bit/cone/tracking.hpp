#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The ring on the bottom on which a row makes its prints. Each tooth prints where its tip is
/// deepest.
struct PrintRing {
  double radius = 0.0;         ///< m, from the bit's axis
  double azimuth_B = 0.0;      ///< rad, of the place of the prints, in the bit frame
  double deepest_angle = 0.0;  ///< rad about the cone's Z (K at angle 0) of a tip at that place
  std::vector<double> angles;  ///< rad, of the teeth, as in ToothRow
  double width = 0.0;          ///< m, of a print, along the ring
};

/// Computes the ring of a row. `penetration` (m): depth of the prints below the bottom; it
/// determines their width.
PrintRing print_ring(const Cone& cone, const ToothRow& row, double penetration);

/// Extent (m, along the ring) of a tooth at its deepest place, in the plane `penetration` (m) above
/// its lowest point.
double print_width(const Cone& cone, const ToothRow& row, double penetration);

/// The touchdown of a tooth: the bit has turned by `turned` (rad), and the print is at `azimuth` in
/// the hole (rad; turned + azimuth_B, not wrapped).
struct Print {
  double turned = 0.0;
  double azimuth = 0.0;
};

/// Returns all touchdowns on a ring while the bit turns from `from` to `to` (rad), by bit (14). The
/// cone rolls at `speed_ratio` > 0 times the bit's speed; both are at angle 0 when turned = 0.
/// Sorted by `turned`. Not in the thesis.
std::vector<Print> prints(const PrintRing& ring, double speed_ratio, double from, double to);

/// Mean number of a row's teeth in contact at a penetration (m) below the lowest point of its tips,
/// bit (15). It does not depend on the spacing. Above 1, a tooth makes contact before the previous
/// one loses contact. Not in the thesis.
double tooth_contact_ratio(const Cone& cone, const ToothRow& row, double penetration);

/// Criteria of tracking, and the duration for which the bit is followed.
struct TrackingOptions {
  double penetration = 5e-3;     ///< m, of a print; determines its width
  double share_of_width = 0.25;  ///< a print tracks if another is closer than this share
  int revolutions = 20;          ///< of the bit, whose prints are evaluated
  int lags = 1;                  ///< number of earlier revolutions to compare with, one by one
};

/// How often teeth fall into earlier prints (thesis 1.2: "tracking").
struct TrackingShare {
  long prints = 0;            ///< number of evaluated prints
  std::vector<double> share;  ///< [lag - 1]: share of prints that track
  double random_phase = 0.0;  ///< the expected share if the phase between revolutions were random
};

/// Computes the tracking of rings on one bottom, with one result per ring. A print tracks at lag k
/// if a print of any ring, made between k - 1 and k revolutions earlier, is closer than
/// `share_of_width` times its own width. Its random-phase value is the fraction of its ring that
/// such places of the last revolution cover: the mean over an unknown phase. `speed_ratios`: per
/// ring, speed of its cone divided by that of the bit, > 0. There is no start-up: earlier prints exist from the beginning.
/// Not in the thesis.
std::vector<TrackingShare> tracking(const std::vector<PrintRing>& rings,
                                    const std::vector<double>& speed_ratios,
                                    const TrackingOptions& options);

/// The shares of several rings together, weighted by their prints.
TrackingShare combined(const std::vector<TrackingShare>& rings);

/// A row of a bit with its ring, and its place in the bit.
struct BitRow {
  int cone = 0;  ///< index into Bit::cones
  int row = 0;   ///< index into ConeLayout::rows
  PrintRing ring;
};

/// All rows of all cones whose teeth lose contact with the bottom, in the bit's order.
std::vector<BitRow> bit_rows(const Bit& bit, double penetration);

/// Tracking of the rows of a bit whose cones turn at `cone_speeds` times the bit's speed.
std::vector<TrackingShare> tracking(const std::vector<BitRow>& rows,
                                    const std::vector<double>& cone_speeds,
                                    const TrackingOptions& options);

}  // namespace tdbd::bit
