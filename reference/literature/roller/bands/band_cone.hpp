#pragma once

#include <vector>

#include "reference/literature/roller/roller_bit.hpp"

/// One cone of Sheppard and Lesage's model (sheppard_lesage.hpp): rows as smooth bands.
namespace tdbd::reference {

/// Rock that resists with a specific energy against the motion, and with a share of it normal to
/// the motion.
struct BandRock {
  double specific_energy = 0.0;  ///< eps, Pa
  double normal_ratio = 0.0;     ///< zeta: force normal to the motion over that against it
};

struct BandOptions {
  /// Half angle of the bands' cone, rad. The journal's angle makes them flat on the bottom; 0 makes
  /// them parallel to the journal.
  double half_angle = 0.0;
  double width = 0.0;  ///< m, along the band's slope; 0: twice the teeth's radius, row by row
  int angles = 400;    ///< number of angles in the sum over the arc
  /// bracket of the ratio of cone speed to bit speed
  double least_ratio = 0.5, greatest_ratio = 2.5;
};

/// Motion of the bit, and the number of cones that share its advance.
struct BandMotion {
  double bit_speed = 0.0;  ///< Omega, rad/s
  double rate = 0.0;       ///< V, m/s, downwards
  std::size_t cones = 3;
};

/// The arc on which a row is in rock: from `entry`, where it begins to move into rock, to `exit`,
/// by which its share of the volume is removed. rad about the journal, 0 at the lowest point,
/// ascending against the motion.
struct BandArc {
  double entry = 0.0, exit = 0.0;
};
BandArc band_arc(const RollerCone& cone, const RollerRow& row, const BandMotion& motion,
                 const BandOptions& options);

/// A strip of a band: the data that do not depend on the cone's speed. In the axes (e_r, e_t, e_z)
/// of the cone.
struct BandStrip {
  Vec3 place, normal, spin;  ///< m; unit, into the rock; m, velocity per cone speed: rho tau
  Vec3 velocity;             ///< m/s, of the bit at this place
  double entering = 0.0;     ///< m/s, component of the velocity along the normal
  double area = 0.0;         ///< m2
  std::size_t row = 0;
};

/// Writes the strips of all rows. Reuses the memory of `strips`.
void lay_strips(const RollerCone& cone, const BandMotion& motion, const BandOptions& options,
                std::vector<BandStrip>& strips);

/// Loads of the rock on a cone.
struct BandLoads {
  Vec3 force = Vec3::Zero();  ///< N, on the cone
  double torque = 0.0;        ///< N m, about the bit's axis, on the cone
  double moment = 0.0;        ///< N m, about the journal, on the cone
  double volume_rate = 0.0;   ///< m3/s
};

/// Loads on all strips, or on one row, at a cone speed (rad/s, negative if it rolls).
BandLoads band_loads(const std::vector<BandStrip>& strips, const BandRock& rock, double cone_speed);
BandLoads row_loads(const std::vector<BandStrip>& strips, const BandRock& rock, double cone_speed,
                    std::size_t row);

}  // namespace tdbd::reference
