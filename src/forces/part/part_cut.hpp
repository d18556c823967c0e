#pragma once

#include "bit/bit.hpp"
#include "core/angles.hpp"
#include "core/types.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// Effect of one part of the bit on the rock in a step: the complete input of a force law. All
/// vectors are in one frame, chosen by the caller; the force is returned in the same frame. Thesis:
/// 4.3, app. C (Acut, De, Ebr, Scc, P).
struct PartCut {
  bit::PartKind kind = bit::PartKind::face;
  double removed_volume = 0.0;   ///< m3, in the step
  double cut_area = 0.0;         ///< m2, cut area normal to the velocity (Acut)
  double contact_area = 0.0;     ///< m2, area pressed by the part, normal to `normal`
  double engaged_edge = 0.0;     ///< m, length of the face's edge in rock (De)
  double path = 0.0;             ///< m, displacement of the contact in the step
  double depth = 0.0;            ///< m, mean thickness of the cut, or the penetration
  double back_rake = 0.0;        ///< rad, effective_back_rake of the face (Ebr)
  double diameter = 0.0;         ///< m, of the cutter; 0: unknown
  Vec3 point = Vec3::Zero();     ///< m, of the contact
  Vec3 velocity = Vec3::Zero();  ///< m/s, of the contact relative to the rock
  Vec3 normal = Vec3::Zero();    ///< unit, from bit into rock: of the profile or of the area
  Strength strength;             ///< of the rock at the contact
};

/// Back rakes (rad) are limited to this value on either side of 0.
inline constexpr double steepest_rake = 80.0 * pi / 180.0;

/// The rock's force on one part of the bit.
struct PartForce {
  Vec3 force = Vec3::Zero();  ///< N, on the bit
  Vec3 point = Vec3::Zero();  ///< m, point of action
  double normal = 0.0;        ///< N, Fn of the law including slip_share, >= 0
  double tangential = 0.0;    ///< N, Ft of the law including slip_share, >= 0
};

/// Mean area of a cut, m2, forces (1): removed volume (m3) divided by the path (m) of the contact;
/// 0 without a path. Independent of the time step for the same cut. Reconstructed.
inline double swept_area(double removed_volume, double path) {
  return path > 0.0 ? removed_volume / path : 0.0;
}

}  // namespace tdbd::forces
