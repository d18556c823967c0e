#pragma once

#include <vector>

#include "bit/cone.hpp"

namespace tdbd::bit {

/// The ring on which the teeth of a row print the bottom: each where its tip is deepest.
struct PrintRing {
  double radius = 0.0;         ///< m, from the bit's axis
  double azimuth_B = 0.0;      ///< rad, of the place in the bit's frame
  double deepest_angle = 0.0;  ///< rad about the cone's Z (K at angle 0) of a tip at the place
  std::vector<double> angles;  ///< rad, of the teeth, as ToothRow
  double width = 0.0;          ///< m, of a print along the ring
};

/// `penetration`: m, depth of the print below the bottom, for its width.
PrintRing print_ring(const Cone& cone, const ToothRow& row, double penetration);

/// Extent (m, along the ring) of a tooth at its deepest place, in the plane that lies `penetration`
/// above its lowest point.
double print_width(const Cone& cone, const ToothRow& row, double penetration);

/// A tooth touches down: the bit has turned by `turned` (rad), and the print stands at `azimuth` in
/// the hole (rad; turned + azimuth_B, not wrapped).
struct Print {
  double turned = 0.0;
  double azimuth = 0.0;
};

/// Where and when all teeth of a ring touch down while the bit turns from `from` to `to` (rad), the
/// cone at `speed_ratio` > 0 times the bit's speed, rolling, both at angle 0 for turned = 0. Tooth
/// with angle a is deepest when a - i turned = deepest_angle, so that
///   turned = (a - deepest_angle + 2 pi m) / i,   m whole                                    [+]
/// Sorted by `turned`.
std::vector<Print> prints(const PrintRing& ring, double speed_ratio, double from, double to);

/// Mean number of a row's teeth in contact at a penetration (m) below the lowest place of its tips:
/// with A the height of the tips' circle, from its centre to its lowest point, a tip is in contact
/// while it stands within psi of the lowest place, A (1 - cos psi) = penetration, and the ratio is
/// N psi / pi, whatever the spacing [+]. Above 1 one tooth takes over before the last lets go.
double tooth_contact_ratio(const Cone& cone, const ToothRow& row, double penetration);

}  // namespace tdbd::bit
