#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Thin cuts under pressure after Miedema, who explains the tests of Zijsling (1987) with this
/// model, forces (10). A chip slides up a shear plane at angle b and then along the face, at the
/// blade angle al = 90 deg + Ebr. The bottom-hole pressure p acts on both, over the heights hi of
/// the cut and hb of the chip:
///   C  = c A/sin b,  W1 = p A/sin b,  W2 = p A (hb/hi)/sin al          A = Acut
///   K2 = (W2 sin(al + b + phi) + W1 sin phi + C cos phi) / sin(al + b + phi + delta)
///   Ft = -W2 sin al + K2 sin(al + delta),  Fn = W2 cos al - K2 cos(al + delta)
/// with c = cohesion_share UCS (1 - sin phi)/(2 cos phi), delta = interface_share phi. Linear in
/// the area and in the pressure. The pressure is that of the bottom hole; pore pressure has no
/// effect (as Zijsling observed in Mancos shale). The back rake is limited to largest_back_rake and
/// the sum of the angles to 170 deg: beyond these, dead rock builds up in front of the face, and
/// the formula has a pole. Forces are not below 0. The formula is from memory; a test compares it
/// with Miedema's published table.
struct ThinCut {
  double shear_angle = 0.20943951023931953;  ///< rad, b: 12 degrees
  double blade_height = 4.04;                ///< 1, hb/hi
  double interface_share = 2.0 / 3.0;        ///< 1, delta/phi
  double cohesion_share = 1.0;  ///< 1, ratio of cohesion to that of unconfined strength and phi
  double largest_back_rake = 0.5235987755982988;  ///< rad: 30 degrees
  double slip_speed = usual_slip_speed;           ///< m/s, see slip_share

  static constexpr std::string_view name = "thin-cut";
  static constexpr bool knows(bit::PartKind kind) { return kind == bit::PartKind::face; }
  static std::span<const Coefficient<ThinCut>> coefficients();
};

PartForce law_force(const ThinCut& law, const PartCut& cut);

}  // namespace tdbd::forces
