#pragma once

#include "verification/battery/rotation_scheme.hpp"

namespace tdbd::battery {

/// Schemes with one mistake each, all easy to make. Every check of the battery must find the
/// mistakes that it claims to find (verification/dynamics/broken_schemes_test).

/// T = h W at the drift's start: first order, not symmetric, not symplectic.
RotationScheme frozen_velocity();
/// Axes 1 2 3 without the way back: symplectic, but first order and not reversible.
RotationScheme no_way_back();
/// Cones follow the body's momentum at the drift's start instead of its mean.
RotationScheme hasty_cones();
/// The momentum in the body frame as state: the spatial one is rotated there and back each step.
RotationScheme body_momentum_first();
/// No renormalisation of the quaternion.
RotationScheme never_renormalised();
/// The cone's spin as state: its momentum is divided and multiplied by the inertia each step.
RotationScheme spin_first();

}  // namespace tdbd::battery
