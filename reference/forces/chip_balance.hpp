#pragma once

namespace tdbd::reference {

/// A chip that slides up a shear plane and along a blade.
struct Chip {
  double blade_angle = 0.0;      ///< rad, between the direction of motion and the blade's front
  double shear_angle = 0.0;      ///< rad, of the shear plane
  double friction_angle = 0.0;   ///< rad, of the rock
  double interface_angle = 0.0;  ///< rad, of friction between chip and blade
  double cohesion = 0.0;         ///< Pa
  double pressure = 0.0;         ///< Pa, around the chip; zero in both planes
  double shear_length = 0.0;     ///< m, of the shear plane
  double blade_length = 0.0;     ///< m, of the chip along the blade
  double width = 0.0;            ///< m
};

/// The chip's force on the blade, N.
struct BladeLoad {
  double against_motion = 0.0;
  double up = 0.0;  ///< away from the rock
};

/// Slow twin of the thin-cut law: solves the chip's equilibrium, a vector equation for the two
/// unknown grain forces on the shear plane and on the blade. Each force is inclined to its plane's
/// normal by the angle of friction and adds to the effect of the missing pressure (and of cohesion)
/// there.
BladeLoad chip_balance(const Chip& chip);

}  // namespace tdbd::reference
