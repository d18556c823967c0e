#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The force law of a part, as resolved by a run.
struct PartLaw {
  std::string law;                                           ///< its name
  std::vector<std::pair<std::string, double>> coefficients;  ///< SI
  std::vector<std::string> areas;  ///< of [forces.areas] that select the part, in ascending rank
};

/// The properties of every part, in the order of the bit, each with the area of the bit file that
/// defined it (`areas`). `laws`: per part; empty if not known, as without a run.
nlohmann::ordered_json properties_json(const Bit& bit, std::span<const PartLaw> laws);

/// The same as a table for a terminal, without laws. Empty if no area defines a property of a part.
std::string areas_report(const Bit& bit);

/// "body" of analysis.json: exposure, slot depth and junk slot area of the blades, and their
/// clearance from the rock at a penetration of `advance` (m) per revolution (bit/body/bit_body.hpp).
/// SI, units in the keys. Requires a bit with blades.
nlohmann::ordered_json body_json(const Bit& bit, double advance);

/// The same as text, a few lines. Empty without blades.
std::string body_text(const Bit& bit, double advance);

}  // namespace tdbd::bit
