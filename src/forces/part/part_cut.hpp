#pragma once

#include <optional>
#include <string_view>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "core/types.hpp"
#include "forces/rock/rock_material.hpp"

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

/// Description of a coefficient of a law L. With it a case reader can handle all laws alike.
template <class L>
struct Coefficient {
  std::string_view key;            ///< key in a case
  std::string_view unit;           ///< of the SI value, in the notation of UDUNITS-2
  double L::*member;               ///< member that stores the value
  std::optional<double> fallback;  ///< default, SI; none: required
  Range range;                     ///< SI
  std::string_view meaning;        ///< one line for users
  /// The kinds of part whose force it can change; the default is all that the law applies to.
  bool (*where)(bit::PartKind) = &L::knows;
};

/// For coefficients that affect only faces.
constexpr bool on_face(bit::PartKind kind) { return kind == bit::PartKind::face; }

/// Default speed below which forces fade, m/s: a thousandth of the speed at the gage of a bit. An
/// addition of TDBD [+].
inline constexpr double default_slip_speed = 1e-3;

/// The coefficient that every law has (slip_share).
template <class L>
Coefficient<L> slip_speed_of() {
  return {"slip_speed",          "m/s",
          &L::slip_speed,        default_slip_speed,
          Range::non_negative(), "speed below which the force fades"};
}

/// The two coefficients of laws whose friction decreases with speed (friction_at).
template <class L>
Coefficient<L> weakening_of() {
  return {"weakening",
          "1",
          &L::weakening,
          0.0,
          Range::within(0.0, 1.0),
          "share of mu that is lost at high speed"};
}
template <class L>
Coefficient<L> weakening_speed_of() {
  return {"weakening_speed",   "m/s",
          &L::weakening_speed, 1.0,
          Range::positive(),   "speed at which most of that is lost"};
}

}  // namespace tdbd::forces
