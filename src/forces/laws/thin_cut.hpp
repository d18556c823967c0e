#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Thin cuts under pressure after Miedema, who explains Zijsling's tests (1987) in this way, forces
/// (10). A chip slides up a shear plane at angle b and then along the face, at the blade angle al =
/// 90 deg + Ebr; the bottom hole's pressure p acts on both, over the heights hi of the cut and hb
/// of the chip:
///   C  = c A/sin b,  W1 = p A/sin b,  W2 = p A (hb/hi)/sin al          A = Acut
///   K2 = (W2 sin(al + b + phi) + W1 sin phi + C cos phi) / sin(al + b + phi + delta)
///   Ft = -W2 sin al + K2 sin(al + delta),  Fn = W2 cos al - K2 cos(al + delta)
/// with c = cohesion_share UCS (1 - sin phi)/(2 cos phi), delta = interface_share phi. Linear in
/// the area and in the pressure; every pressure is that of the bottom hole, none of the pores (as
/// Zijsling saw in Mancos shale). The face counts as no steeper than largest_back_rake, and the
/// angles' sum as at most 170 deg: beyond, dead rock builds up before the face, and the formula has
/// a pole. No force below 0. The formula is from memory; Miedema's published table guards it.
struct ThinCut {
  double shear_angle = 0.20943951023931953;  ///< rad, b: 12 degrees
  double blade_height = 4.04;                ///< 1, hb/hi
  double interface_share = 2.0 / 3.0;        ///< 1, delta/phi
  double cohesion_share = 1.0;  ///< 1, cohesion over that of unconfined strength and phi
  double largest_back_rake = 0.5235987755982988;  ///< rad: 30 degrees
  double slip_speed = usual_slip_speed;           ///< m/s, slip_share

  static constexpr std::string_view name = "thin-cut";
  static constexpr bool knows(bit::PartKind kind) { return kind == bit::PartKind::face; }
  static std::span<const Coefficient<ThinCut>> coefficients();
};

PartForce law_force(const ThinCut& law, const PartCut& cut);

}  // namespace tdbd::forces
