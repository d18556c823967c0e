#pragma once

#include "core/types.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::simulation {

/// Force F of a part's law and a resistance C (N s/m), at one velocity of its point.
struct PartDrag {
  forces::PartForce force;
  Mat3 resistance = Mat3::Zero();
};

/// The resistance C with F = -C v, simulation (7):
///   C = -(F.v/v^2) I + q v^T - v q^T,   q = -(F - (F.v/v^2) v)/v^2
/// C + C^T >= 0 for any law, because laws do no positive work. v: m/s, not 0; F: N.
Mat3 secant_resistance(const Vec3& v, const Vec3& F);

/// Kind of resistance: the secant, which reproduces the force; the tangent -dF/dv by forward
/// differences; or none.
enum class Resistance { secant, tangent, none };

/// Speed at which laws are evaluated at rest, where they have a slope but no direction: a creep
/// into the rock, m/s.
inline constexpr double smallest_speed = 1e-9;

/// Evaluates the law of a part at this velocity (m/s) of its point.
PartDrag drag_of(const ForcePlan& plan, const CutOfPart& cut, const Vec3& v_W, double dt,
                 Resistance which);

}  // namespace tdbd::simulation
