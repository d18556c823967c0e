#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/pressing.hpp"

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
  double slip_speed = usual_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "friction";
  static constexpr bool knows(bit::PartKind kind) {
    return kind != bit::PartKind::face && kind != bit::PartKind::tooth;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Friction>> coefficients();
};

Pressing law_pressing(const Friction& law, const PartCut& cut);

}  // namespace tdbd::forces
