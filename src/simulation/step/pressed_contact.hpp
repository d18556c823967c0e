#pragma once

#include <optional>

#include "forces/part/pressing.hpp"
#include "simulation/step/part_drag.hpp"

namespace tdbd::simulation {

/// A pressing surface (forces (4)) in a step that solves for force and velocity together, by an
/// augmented Lagrangian, simulation (13):
///   p = min(limit, max(0, (p' + k_n (v_n - g/h))/(1 + k_n c))),   c = ramp |v_t|/limit
///   t = t' + k_t v_t, shortened to mu p;                  F = -p n - t
/// g/h is the speed at which the surface returns to rock from which it has risen by g. p' and t'
/// are the normal force and the friction of the last estimate. If the estimate does not change any
/// more, the law is satisfied for any penalties k; they only affect the rate of convergence.
struct PressedContact {
  forces::Pressing law;
  Vec3 normal_W = Vec3::Zero();
  double free_speed = 0.0;         ///< m/s, g/h
  double p = 0.0;                  ///< N, estimate
  Vec3 friction_W = Vec3::Zero();  ///< N, estimate, opposite to the slip
  double k_n = 0.0, k_t = 0.0;     ///< N s/m
  std::optional<double> slip{};    ///< m/s, for mu and c; none: |v_t|
};

/// Force at the velocity v (m/s) of the contact relative to the rock, and its slope -dF/dv. The
/// slope includes the dependence of friction on normal force and speed.
PartDrag drag_of(const PressedContact& contact, const Vec3& v_W);

/// Sets the estimate to the force at this velocity.
void update_estimate(PressedContact& contact, const Vec3& v_W);

}  // namespace tdbd::simulation
