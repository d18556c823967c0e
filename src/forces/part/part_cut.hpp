#pragma once

#include "bit/bit.hpp"
#include "core/angles.hpp"
#include "core/types.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// What one part of the bit did to the rock in a step: all that a force law knows about it. All
/// vectors are in one frame, chosen by the caller; the force comes back in the same frame.
/// Thesis: 4.3, app. C (Acut, De, Ebr, Scc, P).
struct PartCut {
  bit::PartKind kind = bit::PartKind::face;
  double removed_volume = 0.0;   ///< m3, in the step
  double cut_area = 0.0;         ///< m2, of rock cut, normal to the velocity (Acut)
  double contact_area = 0.0;     ///< m2, of rock that the part presses on, normal to `normal`
  double engaged_edge = 0.0;     ///< m, length of a face's edge in rock (De)
  double path = 0.0;             ///< m, travelled by the contact in the step
  double depth = 0.0;            ///< m, mean thickness of the cut, or the penetration
  double back_rake = 0.0;        ///< rad, effective_back_rake of the face (Ebr)
  double diameter = 0.0;         ///< m, of the cutter; 0: unknown
  Vec3 point = Vec3::Zero();     ///< m, of the contact
  Vec3 velocity = Vec3::Zero();  ///< m/s, of the contact over the rock
  Vec3 normal = Vec3::Zero();    ///< unit, from the bit into the rock: the profile's, or the area's
  Strength strength;             ///< of the rock there
};

/// Back rakes (rad) beyond this count as this, on either side of 0.
inline constexpr double steepest_rake = 80.0 * pi / 180.0;

/// The rock's force on one part of the bit.
struct PartForce {
  Vec3 force = Vec3::Zero();  ///< N, on the bit
  Vec3 point = Vec3::Zero();  ///< m, where it acts
  double normal = 0.0;        ///< N, Fn of the law as it acts at this speed, >= 0
  double tangential = 0.0;    ///< N, Ft of the law as it acts at this speed, >= 0
};

/// Mean area of a cut, m2, forces (1): removed volume (m3) over the path (m) of the contact; 0
/// without a path. The length of the step does not matter as long as the cut is the same.
/// Reconstructed.
inline double swept_area(double removed_volume, double path) {
  return path > 0.0 ? removed_volume / path : 0.0;
}

}  // namespace tdbd::forces
