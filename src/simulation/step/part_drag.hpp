#pragma once

#include "core/types.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

/// How a part resists: its law's force F and a resistance C (N s/m), at one velocity of its point.
struct PartDrag {
  forces::PartForce force;
  Mat3 resistance = Mat3::Zero();
};

/// C with F = -C v, simulation (7):
///   C = -(F.v/v^2) I + q v^T - v q^T,   q = -(F - (F.v/v^2) v)/v^2
/// C + C^T >= 0 for any law, as none does positive work. v: m/s, not 0; F: N.
Mat3 secant_resistance(const Vec3& v, const Vec3& F);

/// Which resistance: the one that gives the force, its slope -dF/dv by forward differences, or none.
enum class Resistance { secant, tangent, none };

/// At rest laws have a slope but no direction: they are asked at a creep into the rock, m/s.
inline constexpr double smallest_speed = 1e-9;

/// The law of a part at this velocity (m/s) of its point.
PartDrag drag_of(const ForcePlan& plan, const CutOfPart& cut, const Vec3& v_W, double dt,
                 Resistance which);

}  // namespace tdbd::simulation
