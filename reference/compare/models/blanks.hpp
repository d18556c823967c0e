#pragma once

#include <cmath>
#include <vector>

#include "reference/compare/model.hpp"

/// Reasons and notes that several models share.
namespace tdbd::reference {

inline const std::vector<Quantity> of_cones{Quantity::cone_speed_ratio, Quantity::teeth_in_contact,
                                            Quantity::teeth_in_contact_variance};
inline const std::vector<Quantity> flats{Quantity::largest_wear_flat, Quantity::hottest_flat};
inline const std::vector<Quantity> of_weight{Quantity::rate_at_weight, Quantity::torque_at_weight};
inline const std::vector<Quantity> lateral{Quantity::imbalance, Quantity::imbalance_direction,
                                           Quantity::side_force};
inline const std::vector<Quantity> noises{Quantity::torque_noise, Quantity::torque_noise_5ms};

inline const std::vector<Quantity> of_free_bits{Quantity::rate_of_penetration,
                                                Quantity::whirl_radius};

inline constexpr const char* no_cones = "the bit has no cones";
inline constexpr const char* no_spokes = "no spokes: every cutter is felt in every step";
inline constexpr const char* no_wear = "it has no law of wear";
inline constexpr const char* given_rate =
    "it is led at a given rate here; its equations of motion find the rate of a weight";
inline constexpr const char* law_of_tips =
    "its forces are width times depth of tips that share the radius; those of TDBD act on the area";
inline constexpr const char* no_cutters = "the bit has no cutters";
inline constexpr const char* no_weight =
    "no reference weight: neither compare.weight_on_bit nor a model that finds one";

/// Azimuth of a force in the bit's frame, rad.
inline double direction_of(const Eigen::Vector2d& force_B) {
  return std::atan2(force_B.y(), force_B.x());
}

/// For models on spokes with a free bit.
inline void set_free_missing(Findings& f) {
  set_missing(f, Quantity::torque_noise_by_crossing, "its cutters are felt in every step");
  set_missing(f, flats, no_wear);
  set_missing(f, of_cones, no_cones);
}

/// For models with a fixed axis: their results for a whirling bit are those of steady drilling.
inline void add_whirl_note(const CompareCase& c, Findings& f) {
  if (c.ours.motion.kind == simulation::MotionKind::whirl)
    f.notes.emplace_back("no lateral motion: the numbers are those of the bit drilling steadily");
}

}  // namespace tdbd::reference
