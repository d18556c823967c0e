#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/profile/bit_analysis.hpp"

namespace tdbd::bit {

/// Normal over cutting force of the planar model in reports: the default of parameter studies.
inline constexpr double report_normal_ratio = 0.8;

/// "balance" of analysis.json: the planar imbalance with its normal and its drag part, over the
/// weight, as magnitudes and vectors (bit frame). Null without a cutter that carries weight.
nlohmann::ordered_json balance_json(const std::vector<Cutter>& cutters, const Engagement& e);

/// The facts of a bit for a terminal, at most 30 lines: gage, cutters, blades, profile, what cuts at
/// an advance (m per revolution), balance, and the body with its clearance from the rock.
std::string facts_text(const Bit& bit, double advance);

/// One row per cutter: place, rakes and diameter, in mm and degrees.
std::string cutters_text(const Bit& bit);

/// One row per part: kind, whether it cuts, triangles, volume and mass.
std::string parts_text(const Bit& bit);

}  // namespace tdbd::bit
