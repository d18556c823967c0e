#pragma once

#include <vector>

#include "reference/literature/roller/roller_bit.hpp"

/// Which teeth touch a flat bottom, after Ma and Azar, thesis 2.2. Stated in the thesis: mean rates
/// of rotation as input, statistical arguments instead of dynamics, equally spaced teeth in a row.
/// Not known: the equations. Those used here are derived for a row of equal teeth that turns
/// uniformly.
namespace tdbd::reference {

/// A row of equal teeth that enters a flat bottom.
struct RowContact {
  double half_angle = 0.0;  ///< gamma_c, rad: a tooth touches while |gamma| < gamma_c
  double share = 0.0;       ///< fraction of time in which a tooth is in contact
  double duration = 0.0;    ///< s, of one contact; 0 for a cone at rest
  double mean = 0.0;        ///< number of teeth in contact
  double variance = 0.0;
  double impressions = 0.0;  ///< per revolution of the bit
};

/// Speed and penetration of a row.
struct RowEntry {
  double penetration = 0.0;  ///< m, of the row's lowest point below the flat bottom
  double ratio = 0.0;        ///< ratio of cone speed to bit speed
  double bit_speed = 0.0;    ///< rad/s
};

/// cos(gamma_c) = 1 - penetration/(rho cos beta). The number of teeth in contact is floor(m) or
/// floor(m) + 1 with m = n gamma_c/pi, so its variance is f (1 - f), with f the fractional part of
/// m. Throws InputError for a row that is empty or unequally spaced, and for a penetration that is
/// not finite.
RowContact row_contact(const RollerCone& cone, const RollerRow& row, const RowEntry& entry);

/// Statistics of rows that turn independently: means and variances are added.
struct ContactStatistics {
  double mean = 0.0, variance = 0.0;
};
ContactStatistics together(const std::vector<RowContact>& rows);

/// All rows of a bit on a bottom that every row penetrates by the same depth (m), cone by cone.
struct BitContact {
  std::vector<RowContact> rows;
  ContactStatistics all;
};

/// `ratios`: speed of each cone divided by that of the bit. Throws InputError as row_contact
/// does, and if the bit violates the model's assumptions (require_equal_cones).
BitContact bit_contact(const RollerBit& bit, const std::vector<double>& ratios, double bit_speed,
                       double penetration);

/// Checks the model's assumptions, stated in the thesis: cones at equal angles and at the same
/// elevation. (row_contact checks that teeth are equally spaced.) Throws InputError that names the
/// first violated one.
void require_equal_cones(const RollerBit& bit);

/// Distance of a row's prints from those of the previous passage over the same track, in pitches
/// from 0 (tracking) to 1/2. `impressions`: of the row per revolution. `turned`: revolutions of the
/// bit between the two passages, 1 for the same cone, 1/3 for the next of three equal cones.
/// `shift`: pitches by which gamma_0 of the later row's teeth is larger.
double print_offset(double impressions, double turned, double shift = 0.0);

/// Whether prints are within `tolerance` pitches of those of the previous passage.
bool tracks(double impressions, double turned, double shift = 0.0, double tolerance = 1e-9);

}  // namespace tdbd::reference
