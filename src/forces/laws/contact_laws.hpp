#pragma once

#include <span>
#include <string_view>

#include "forces/part/directions.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Friction of gage pads, the body and the blunt sides of cutters, forces (11): a contact stress on
/// the contact area, limited by the strength of the rock, and Coulomb friction. An addition of TDBD
/// [+].
///   Fn <= min(stress, cap Scc) A,  Ft <= mu Fn;  forces (4) with ramp = tan full_angle
/// A pad that only slides along the wall has no normal force. If it moves into the wall at an angle
/// of at least full_angle, it has the full stress. full_angle = 0 is a rigid-plastic wear flat. mu
/// may decrease with speed (friction_at).
struct Friction {
  double stress = 0.0;           ///< Pa, contact stress
  double mu = 0.0;               ///< 1, coefficient of friction
  double cap = 1.5;              ///< 1, largest ratio of contact stress to confined strength
  double full_angle = 0.01;      ///< rad, angle of motion into the rock at which the stress is full
  double weakening = 0.0;        ///< 1, relative decrease of mu with speed, see friction_at
  double weakening_speed = 1.0;  ///< m/s
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "friction";
  static constexpr bool knows(bit::PartKind kind) {
    return kind != bit::PartKind::face && kind != bit::PartKind::tooth;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Friction>> coefficients();
};

Pressing law_pressing(const Friction& law, const PartCut& cut);

/// A tooth or shell of a roller cone that is pressed into the rock, forces (12): a crushing
/// pressure on the contact, and Coulomb friction along the slip, which drives the cones. An
/// addition of TDBD [+]; its form is that of element laws in the literature, from memory.
///
///   Fn <= ratio Scc A,  Ft <= mu Fn          A: contact area seen along `normal`; forces (4)
/// The growth of the force with penetration follows from the contact area: linear for a wedge,
/// nearly linear for a sphere, quadratic for a cone. There is no elastic recovery: a tooth that
/// leaves the rock has no force.
struct Indentation {
  double ratio = 1.0;            ///< 1, ratio of crushing pressure to confined strength
  double mu = 0.3;               ///< 1, friction between tooth and rock
  double weakening = 0.0;        ///< 1, relative decrease of mu with speed, see friction_at
  double weakening_speed = 1.0;  ///< m/s
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "indentation";
  static constexpr bool knows(bit::PartKind kind) {
    return kind == bit::PartKind::tooth || kind == bit::PartKind::cone;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Indentation>> coefficients();
};

Pressing law_pressing(const Indentation& law, const PartCut& cut);

/// No force: the part only cuts the rock.
struct NoForce {
  static constexpr std::string_view name = "none";
  static constexpr bool knows(bit::PartKind) { return true; }
  static std::span<const Coefficient<NoForce>> coefficients() { return {}; }
};

inline PartForce law_force(const NoForce&, const PartCut& cut) {
  return {.force = Vec3::Zero(), .point = cut.point, .normal = 0.0, .tangential = 0.0};
}

}  // namespace tdbd::forces
