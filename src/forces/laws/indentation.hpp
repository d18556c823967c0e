#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/pressing.hpp"

namespace tdbd::forces {

/// A tooth or shell of a roller cone that is pressed into the rock, forces (12): a crushing
/// pressure on the contact, and Coulomb friction along the slip, which drives the cones. An
/// addition of TDBD [+]; its form is that of element laws in the literature, from memory.
///
///   Fn <= ratio Scc A,  Ft <= mu Fn          A: contact area seen along `normal`; forces (4)
/// The growth of the force with penetration follows from the contact area: linear for a wedge,
/// nearly linear for a sphere, quadratic for a cone. There is no elastic recovery: a tooth that
/// leaves the rock has no force.
struct Indentation {
  double ratio = 1.0;                    ///< 1, ratio of crushing pressure to confined strength
  double mu = 0.3;                       ///< 1, friction between tooth and rock
  double weakening = 0.0;                ///< 1, relative decrease of mu with speed, see friction_at
  double weakening_speed = 1.0;          ///< m/s
  double slip_speed = usual_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "indentation";
  static constexpr bool knows(bit::PartKind kind) {
    return kind == bit::PartKind::tooth || kind == bit::PartKind::cone;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Indentation>> coefficients();
};

Pressing law_pressing(const Indentation& law, const PartCut& cut);

}  // namespace tdbd::forces
