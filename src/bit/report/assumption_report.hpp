#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bit/cone/cone_assumptions.hpp"

namespace tdbd::bit {

/// Adds to each of the "cones" of analysis.json its asymmetry, the offset of its centre of mass
/// and, under "assumptions", their effect if the bit turns at bit_speed (rad/s) and the cone rolls
/// on its gage row (bit/cone/cone_assumptions.hpp). SI, units in the keys.
void add_assumptions(const Bit& bit, double bit_speed, nlohmann::ordered_json& file);

/// The same as text, one line per cone. Empty without cones.
std::string assumptions_text(const Bit& bit, double bit_speed);

}  // namespace tdbd::bit
