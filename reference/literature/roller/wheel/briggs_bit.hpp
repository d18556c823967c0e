#pragma once

#include "reference/literature/roller/roller_bit.hpp"
#include "reference/literature/roller/wheel/briggs_wedge.hpp"
#include "reference/literature/roller/wheel/briggs_wheel.hpp"

namespace tdbd::reference {

/// A bit in Briggs's model: equal sprockets that roll around the hole on one circle. No offset, no
/// gage, virgin rock in front of every wheel. Reconstructed.
struct BriggsBit {
  Sprocket wheel;
  int wheels = 3;
  double track_radius = 0.0;  ///< R_m, m, of the circle on which they roll
};

/// Makes the sprockets that represent one row of a bit's cones; all cones have an equal one. Wedges
/// of this half-angle and width replace the row's teeth. Their track is at the row's lowest tooth,
/// L cos beta + rho sin beta from the bit's axis; the offset is neglected. Throws InputError if
/// there is no such row.
BriggsBit briggs_bit(const RollerBit& bit, std::size_t cone, std::size_t row, double half_angle,
                     double width);

/// The bit in steady drilling.
struct BriggsDrilling {
  double penetration = 0.0;     ///< m, of the tips at their lowest point
  double rolling_radius = 0.0;  ///< m, of freely rolling wheels
  double cone_ratio = 0.0;      ///< turns of a wheel per turn of the bit: R_m/rolling radius
  double weight = 0.0;          ///< WOB, N: sum of the wheels' loads
  double torque = 0.0;          ///< TOB, N m: sum of their drags times R_m
  double advance = 0.0;         ///< m per revolution: height removed by the wheels
  double rate = 0.0;            ///< m/s
  Rolling wheel;                ///< of one wheel, with its time series
};

/// Computes the bit at a given penetration. Throws InputError as roll and free_rolling_radius do.
BriggsDrilling briggs_at_penetration(const BriggsBit& bit, const CoulombRock& rock,
                                     double penetration, double rotary_speed,
                                     const RollingOptions& options = {});

/// Computes the bit at the penetration at which the wheels carry the weight (N). Throws InputError
/// if no penetration below the depth at which teeth undercut carries it.
BriggsDrilling briggs_under_weight(const BriggsBit& bit, const CoulombRock& rock, double weight,
                                   double rotary_speed, const RollingOptions& options = {});

/// The inverse: cohesion (Pa) of a rock of this friction angle in which the bit has this rate (m/s)
/// under this weight. The rate determines the penetration, independent of the rock, and the weight
/// then determines the pressure. Throws InputError if no penetration gives the rate.
double briggs_cohesion(const BriggsBit& bit, double friction_angle, double weight, double rate,
                       double rotary_speed, const RollingOptions& options = {});

}  // namespace tdbd::reference
