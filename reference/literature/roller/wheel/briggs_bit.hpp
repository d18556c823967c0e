#pragma once

#include "reference/literature/roller/roller_bit.hpp"
#include "reference/literature/roller/wheel/briggs_wedge.hpp"
#include "reference/literature/roller/wheel/briggs_wheel.hpp"

namespace tdbd::reference {

/// A bit as Briggs's model knows it: equal sprockets that roll around the hole on one circle. No
/// offset, no gage, virgin rock before every wheel. Reconstructed.
struct BriggsBit {
  Sprocket wheel;
  int wheels = 3;
  double track_radius = 0.0;  ///< R_m, m, of the circle on which they roll
};

/// The sprockets that stand for one row of a bit's cones: all cones have one like it. Wedges of this
/// half-angle and width in place of the row's teeth; their track is where its lowest tooth stands, L cos
/// beta + rho sin beta from the bit's axis; the offset is lost. Throws InputError: no such row.
BriggsBit briggs_bit(const RollerBit& bit, std::size_t cone, std::size_t row, double half_angle,
                     double width);

/// The bit in steady drilling.
struct BriggsDrilling {
  double penetration = 0.0;     ///< m, of the tips at their lowest
  double rolling_radius = 0.0;  ///< m, of wheels that turn freely
  double cone_ratio = 0.0;      ///< turns of a wheel in a turn of the bit: R_m/rolling radius
  double weight = 0.0;          ///< WOB, N: sum of the wheels' loads
  double torque = 0.0;          ///< TOB, N m: sum of their drags times R_m
  double advance = 0.0;         ///< m per revolution: what the wheels take off their track
  double rate = 0.0;            ///< m/s
  Rolling wheel;                ///< one wheel's, with its time series
};

/// From the penetration. Throws InputError as roll and free_rolling_radius do.
BriggsDrilling briggs_at_penetration(const BriggsBit& bit, const CoulombRock& rock,
                                     double penetration, double rotary_speed,
                                     const RollingOptions& options = {});

/// From the weight (N): the penetration at which the wheels carry it. Throws InputError if none below
/// the depth at which teeth undercut carries it.
BriggsDrilling briggs_under_weight(const BriggsBit& bit, const CoulombRock& rock, double weight,
                                   double rotary_speed, const RollingOptions& options = {});

/// The other way: cohesion (Pa) of a rock of this friction angle in which the bit, under this weight,
/// has this rate (m/s). The rate gives the penetration whatever the rock, and the weight its
/// pressure. Throws InputError if no penetration gives the rate.
double briggs_cohesion(const BriggsBit& bit, double friction_angle, double weight, double rate,
                       double rotary_speed, const RollingOptions& options = {});

}  // namespace tdbd::reference
