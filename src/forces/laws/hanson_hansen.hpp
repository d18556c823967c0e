#pragma once

#include <array>
#include <span>
#include <string_view>

#include "forces/part/directions.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// A law with the ingredients of Hanson and Hansen (1995), which the thesis calibrates in chapter
/// 6, forces (6). RECONSTRUCTED: the names of the quantities of app. C are known, its equations are
/// not. The following equations are additions of TDBD [+]:
///   Scc  = unconfined + pressure_share (confined - unconfined)
///   B1   = A1 (1 + A2 tan Ebr),  B2 = tan(Ebr + A3), not below 0
///   face:    Ft = Scc (B1 Acut + A4 te De),  Fn = B2 Ft
///   chamfer: Fn = A5 Scc A,  Ft = A6 Fn      A: contact area
///   F    = -Ft E1 - Fn E2 for both           forces (3), part_cut.hpp
///   other surfaces of a cutter (cse, cutter_body):  Fn <= A7 Scc A,  Ft <= A8 Fn,  forces (4)
/// Rs of the thesis is interpreted as the slope of Scc over pressure: pressure_share times that of
/// the rock. Ebr + A3 is limited to +-80 degrees. A7 and A8 have an effect only on bits with cse
/// parts, or if the law is assigned to cutter bodies by name. Thesis: app. C.1 to C.4.
struct HansonHansen {
  double A1 = 0.0;              ///< 1, ratio of tangential stress to Scc at zero back rake
  double A2 = 0.0;              ///< 1, its growth with tan Ebr
  double A3 = 0.0;              ///< rad, friction angle between face and rock
  double A4 = 0.0;              ///< 1, ratio of the stress along the edge to Scc
  double te = 1e-4;             ///< m, length scale of A4: only te A4 has an effect
  double A5 = 0.0;              ///< 1, ratio of the contact stress of a chamfer to Scc
  double A6 = 0.0;              ///< 1, friction of a chamfer
  double A7 = 0.0;              ///< 1, contact stress of other surfaces over Scc
  double A8 = 0.0;              ///< 1, friction of other surfaces
  double pressure_share = 1.0;  ///< 1
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "hanson-hansen";
  static constexpr bool knows(bit::PartKind kind) { return bit::belongs_to_a_cutter(kind); }
  static constexpr bool presses(bit::PartKind kind) { return bit::is_side_of_a_cutter(kind); }
  static std::span<const Coefficient<HansonHansen>> coefficients();
};

/// Force on faces and chamfers, forces (3).
PartForce law_force(const HansonHansen& law, const PartCut& cut);

/// Pressing of the other surfaces of a cutter, forces (4).
Pressing law_pressing(const HansonHansen& law, const PartCut& cut);

/// Number of terms in which the force is linear: A1, A1 A2, A4 (face), A5, A5 A6 (chamfer), A7, A7
/// A8 (other).
inline constexpr int hanson_hansen_terms = 7;

/// The factors of these terms.
std::array<double, hanson_hansen_terms> linear_coefficients(const HansonHansen& law);

/// The force of each term with factor 1 (N per unit of the factor). The force of the law is the sum
/// of linear_coefficients times these for any values of the factors, with A3, te, pressure_share
/// and slip_speed of the law. Calibration therefore is a linear least-squares problem.
std::array<Vec3, hanson_hansen_terms> force_basis(const HansonHansen& law, const PartCut& cut);

}  // namespace tdbd::forces
