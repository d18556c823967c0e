#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Power laws in the depth of cut, Glowka (1989), forces (9):
///   Fn = Cn (de/d0)^nn,  Fd = Cd (de/d0)^nd,  d0 = 1 mm
/// de is the depth of a groove in flat rock with the same cut area as the actual cut
/// (virgin_groove.hpp). The coefficients come from tests of one cutter at one speed and rake,
/// including chamfer and wear flat, so the other parts of the cutter should have no law of their
/// own. The effective depth is from memory of his work (RECONSTRUCTED). Fitted coefficients:
/// fits.hpp. Requires the diameter of the cutter.
struct Glowka {
  double Cn = 0.0;                       ///< N, normal force at 1 mm
  double nn = 0.0;                       ///< 1, exponent of the normal force
  double Cd = 0.0;                       ///< N, drag at 1 mm
  double nd = 0.0;                       ///< 1, exponent of the drag
  double slip_speed = usual_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "glowka";
  static constexpr double reference_depth = 1e-3;  // m, d0
  static constexpr bool needs_diameter = true;
  static constexpr bool knows(bit::PartKind kind) { return kind == bit::PartKind::face; }
  static std::span<const Coefficient<Glowka>> coefficients();
};

PartForce law_force(const Glowka& law, const PartCut& cut);

}  // namespace tdbd::forces
