#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/pressing.hpp"

namespace tdbd::forces {

/// A tooth of a roller cone, or the cone's shell, pressed into the rock, forces (12): a crushing
/// pressure on the contact, and Coulomb friction along the slip, which turns the cones. Ours; the
/// form is that of element laws in the literature, from memory.
///
///   Fn <= ratio Scc A,  Ft <= mu Fn          A: contact area seen along `normal`; forces (4)
/// How the force grows with penetration follows from the contact: linear for a wedge, nearly linear
/// for a sphere, quadratic for a cone. Nothing springs back: a tooth that leaves the rock is
/// released.
struct Indentation {
  double ratio = 1.0;                    ///< 1, crushing pressure over the confined strength
  double mu = 0.3;                       ///< 1, friction between tooth and rock
  double weakening = 0.0;                ///< 1, of mu with speed, friction_at
  double weakening_speed = 1.0;          ///< m/s
  double slip_speed = usual_slip_speed;  ///< m/s, slip_share

  static constexpr std::string_view name = "indentation";
  static constexpr bool knows(bit::PartKind kind) {
    return kind == bit::PartKind::tooth || kind == bit::PartKind::cone;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Indentation>> coefficients();
};

Pressing law_pressing(const Indentation& law, const PartCut& cut);

}  // namespace tdbd::forces
