#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_measures.hpp"

namespace tdbd::bit {

/// Adds to each of the "cones" of analysis.json its asymmetry, the offset of its centre of mass
/// and, under "assumptions", their effect if the bit turns at bit_speed (rad/s) and the cone rolls
/// on its gage row (bit/cone/cone_assumptions.hpp). SI, units in the keys.
void add_assumptions(const Bit& bit, double bit_speed, nlohmann::ordered_json& file);

/// The same as text, one line per cone. Empty without cones.
std::string assumptions_text(const Bit& bit, double bit_speed);

/// The data of each cone and of its rows, and the clearances between cones, as text.
std::string cones_text(const Bit& bit);

/// The same for bit.json: an array of cones. SI, units in the keys.
nlohmann::ordered_json cones_json(const Bit& bit);

/// The speeds of a bit's cones in the report, and the penetration of their teeth into the bottom.
struct ConeOperation {
  std::vector<double> cone_speeds;  ///< over the bit's, one for each cone, > 0
  double penetration = 5e-3;        ///< m
};

/// Returns the operation with the given speeds or, if none are given, with each cone's rolling
/// ratio of its gage row. Throws InputError (--cone-speeds) if their number differs from that of
/// the cones, or if one of them is not between 0 and 100.
ConeOperation cone_operation(const Bit& bit, const std::vector<double>& cone_speeds,
                             double penetration);

/// Adds to analysis.json how often the teeth fall into earlier prints and how many are on the
/// bottom at once (bit/cone/tracking.hpp). Adds nothing for a bit without cones. Values are null
/// for a row that never loses contact with the bottom (a nose tooth on the journal) and so has no
/// prints. The keys:
///   cones[].speed_ratio, .rolling_ratio_gage_row    the cone's speed over the bit's; without slip
///   cones[].tracking_share, .tracking_share_random_phase, .tracking_share_by_lag
///       of all its prints; lags 1 to 6, of which tracking_share is the first
///   cones[].rows[].prints_per_revolution, .print_width_m, .tooth_contact_ratio
///       and the three shares of the row
///   tracking.penetration_m, .share_of_width, .revolutions    the settings
///       and the three shares of the whole bit
///   tracking.sweep.speed_ratio, .tracking_share, .tracking_share_random_phase
///       lag 1 of the whole bit, with all cones at one speed from 1 to 1.8 times the bit's
void add_tracking(const Bit& bit, const ConeOperation& operation, nlohmann::ordered_json& file);

/// The data of the rows as text.
std::string tracking_text(const Bit& bit, const ConeOperation& operation);

}  // namespace tdbd::bit
