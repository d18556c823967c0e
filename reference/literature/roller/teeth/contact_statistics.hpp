#pragma once

#include <vector>

#include "reference/literature/roller/roller_bit.hpp"

/// Which teeth touch a flat bottom, after Ma and Azar, thesis 2.2. Seen in the thesis: mean rates
/// of turning as input, statistical arguments in place of dynamics, teeth evenly spaced in a row.
/// Not seen: the equations. Those here follow from a row of equal teeth that turns evenly.
namespace tdbd::reference {

/// A row of equal teeth that enters a flat bottom.
struct RowContact {
  double half_angle = 0.0;  ///< gamma_c, rad: a tooth touches while |gamma| < gamma_c
  double share = 0.0;       ///< of the time that a tooth touches
  double duration = 0.0;    ///< s, of one contact; 0 for a cone at rest
  double mean = 0.0;        ///< teeth that touch
  double variance = 0.0;
  double impressions = 0.0;  ///< per revolution of the bit
};

/// How a row is turned, and how deep it works.
struct RowEntry {
  double penetration = 0.0;  ///< m, of the row's lowest point below the flat bottom
  double ratio = 0.0;        ///< cone speed over bit speed
  double bit_speed = 0.0;    ///< rad/s
};

/// cos(gamma_c) = 1 - penetration/(rho cos beta). The number of teeth that touch is floor(m) or
/// floor(m) + 1 with m = n gamma_c/pi, so its variance is f (1 - f), f the fraction of m. Throws
/// InputError for a row that is empty or unevenly spaced, and for a penetration that is not finite.
RowContact row_contact(const RollerCone& cone, const RollerRow& row, const RowEntry& entry);

/// Rows that turn independently: means and variances add.
struct ContactStatistics {
  double mean = 0.0, variance = 0.0;
};
ContactStatistics together(const std::vector<RowContact>& rows);

/// All rows of a bit on a bottom that every row enters by the same penetration (m), cone by cone.
struct BitContact {
  std::vector<RowContact> rows;
  ContactStatistics all;
};

/// `ratios`: one for each cone, its speed over the bit's (rad/s). Throws InputError as row_contact
/// does and where the bit is none of those that the model takes (need_equal_cones).
BitContact bit_contact(const RollerBit& bit, const std::vector<double>& ratios, double bit_speed,
                       double penetration);

/// The model's assumptions, seen in the thesis: cones at equal angles and at the same elevation
/// (that their teeth are evenly spaced, row_contact sees to). Throws InputError that names the
/// first that the bit breaks.
void need_equal_cones(const RollerBit& bit);

/// How far a row's prints fall from those of the passage before over the same track, in pitches from
/// 0 (tracking) to 1/2. `impressions` of the row per revolution; `turned`: revolutions of the bit
/// between the two passages, 1 for the same cone, 1/3 for the next of three equal cones; `shift`:
/// pitches by which the gamma_0 of the later row's teeth are larger.
double print_offset(double impressions, double turned, double shift = 0.0);

/// Whether prints fall within `tolerance` pitches on those of the passage before.
bool tracks(double impressions, double turned, double shift = 0.0, double tolerance = 1e-9);

}  // namespace tdbd::reference
