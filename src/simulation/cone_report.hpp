#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/cone_interference.hpp"
#include "bit/cone_measures.hpp"

namespace tdbd::simulation {

/// "an overlap of 1.203 mm of cone-1/row-2/tooth-1 (at 34.2 deg) and cone-2/body (at 120.0 deg) at
/// (1.0, 2.0, 3.0) mm", or "a gap of ..."; angles of the cones, place in the bit's frame.
std::string clearance_text(const bit::Clearance& c);

/// Each cone's figures, its rows', and the clearances between cones, as lines for a reader.
std::string cones_text(const bit::Bit& bit);

/// The same for bit.json: an array of cones. SI, units in the keys.
nlohmann::ordered_json cones_json(const bit::Bit& bit);

}  // namespace tdbd::simulation
