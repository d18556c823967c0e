#pragma once

#include <vector>

#include "reference/literature/roller/bands/band_cone.hpp"
#include "reference/literature/roller/roller_bit.hpp"

/// The roller cone bit of Sheppard and Lesage (1988), thesis 2.2. Stated in the thesis: rate of
/// penetration and torque from rotary speed and weight; cone speeds at an instant; the journal as a
/// unit vector; no inertia, no history of the bottom; the mean volume of rock, no single teeth. Not
/// known: the equations. Reconstructed: each row is a smooth band that removes its share of the
/// advance on an arc, against a specific energy along the motion and a share of it normal to the
/// motion. A cone turns so that the torque about its journal is zero. Bands have no tooth angles,
/// so the loads do not change as the bit turns. Hence, for free cones,
///   weight rate + torque speed = specific energy x volume rate.
namespace tdbd::reference {

/// Results for a free cone. Axes (e_r, e_t, e_z) of its azimuth.
struct BandCone {
  double ratio = 0.0;  ///< ratio of cone speed to bit speed
  BandLoads loads;
  std::vector<BandLoads> rows;
  double lag = 0.0;  ///< s, time constant of its speed: inertia over d(moment)/d(speed)
};

struct SheppardLesage {
  double weight = 0.0;          ///< N, on the bit
  double torque = 0.0;          ///< N m, on the bit
  double rate = 0.0;            ///< m/s
  double advance = 0.0;         ///< m per revolution
  double volume_rate = 0.0;     ///< m3/s
  Vec3 lateral = Vec3::Zero();  ///< N, on the bit, normal to its axis; journals at their azimuths
  std::vector<BandCone> cones;
  int evaluations = 0;  ///< of a cone's moment
};

/// Computes one free cone; `motion.cones` cones share the advance.
BandCone free_cone(const RollerCone& cone, const BandRock& rock, const BandMotion& motion,
                   const BandOptions& options, int& evaluations);

/// Computes the bit at a given advance, m per revolution; `bit_speed` in rad/s. Throws InputError
/// for a bit without rows, for values that are not positive, and if there is no root.
SheppardLesage sheppard_lesage(const RollerBit& bit, const BandRock& rock, double bit_speed,
                               double advance, const BandOptions& options = {});

/// Computes the bit under a given weight, N. The advance is searched up to `most_advance`, m per
/// revolution.
SheppardLesage sheppard_lesage_under(const RollerBit& bit, const BandRock& rock, double bit_speed,
                                     double weight, const BandOptions& options = {},
                                     double most_advance = 0.02);

/// Ratio of cone speed to bit speed in two limits of slip, for rows with given weights (any unit). Under friction of constant magnitude, it is that of the weighted median row. Under a
/// viscous resistance, it is the weighted mean sum(w rho R) / sum(w rho^2). R: distance of the
/// row's lowest point from the bit's axis.
double ratio_under_constant_friction(const RollerCone& cone, const std::vector<double>& weights);
double ratio_under_viscous_slip(const RollerCone& cone, const std::vector<double>& weights);

/// End of a row's arc for a small advance without offset: sqrt(2 R d / (3 L rho)), rad.
double small_arc(const RollerCone& cone, const RollerRow& row, double advance);

}  // namespace tdbd::reference
