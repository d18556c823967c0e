#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// "body" of analysis.json: exposure, slot depth and junk slot area of the blades, and their
/// clearance from the rock at a penetration of `advance` (m) per revolution (bit/body/rubbing.hpp).
/// SI, units in the keys. Requires a bit with blades.
nlohmann::ordered_json body_json(const Bit& bit, double advance);

/// The same as text, a few lines. Empty without blades.
std::string body_text(const Bit& bit, double advance);

}  // namespace tdbd::bit
