#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_measures.hpp"

namespace tdbd::bit {

/// The data of each cone and of its rows, and the clearances between cones, as text.
std::string cones_text(const Bit& bit);

/// The same for bit.json: an array of cones. SI, units in the keys.
nlohmann::ordered_json cones_json(const Bit& bit);

}  // namespace tdbd::bit
