#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/pressing.hpp"

namespace tdbd::forces {

/// Rubbing of gage pads, the body and a cutter's blunt sides, forces (11): a contact stress on the
/// contact area, never above what the rock carries, and Coulomb friction. Ours.
///   Fn <= min(stress, cap Scc) A,  Ft <= mu Fn;  forces (4) with ramp = tan full_angle
/// A pad that only slides along the wall carries nothing; moving into it, it carries the full stress
/// from full_angle on. full_angle = 0 is a wear flat: rigid-plastic. mu may fall with speed
/// (friction_at).
struct Friction {
  double stress = 0.0;           ///< Pa, contact stress
  double mu = 0.0;               ///< 1, coefficient of friction
  double cap = 1.5;              ///< 1, largest contact stress over the confined strength
  double full_angle = 0.01;      ///< rad, of motion into the rock at which the stress is whole
  double weakening = 0.0;        ///< 1, of mu with speed, friction_at
  double weakening_speed = 1.0;  ///< m/s
  double slip_speed = usual_slip_speed;  ///< m/s, slip_share

  static constexpr std::string_view name = "friction";
  static constexpr bool knows(bit::PartKind kind) {
    return kind != bit::PartKind::face && kind != bit::PartKind::tooth;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Friction>> coefficients();
};

Pressing law_pressing(const Friction& law, const PartCut& cut);

}  // namespace tdbd::forces
