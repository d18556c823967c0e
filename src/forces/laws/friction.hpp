#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Rubbing of gage pads, the body and a cutter's blunt sides, forces (11): a contact stress on the
/// contact area, never above what the rock carries, and Coulomb friction. Ours.
///   Fn = min(stress, cap Scc) A s,  Ft = mu Fn,  s = min(1, tan b / tan full_angle), 0 for b < 0
/// b is the angle between the surface and its motion into the rock. A pad that only slides along
/// the wall carries nothing (s = 0); moving into it, it soon carries the full stress. With
/// full_angle 0, for a wear flat, s = 1. mu may fall with speed (friction_at). Directions:
/// pressing_force.
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
  static std::span<const Coefficient<Friction>> coefficients();
};

PartForce law_force(const Friction& law, const PartCut& cut);

}  // namespace tdbd::forces
