#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/cutter/cutter_overlap.hpp"

namespace tdbd::bit {

/// "cutter_overlaps" of analysis.json: the pairs and the volumes that count twice in the mass. SI.
nlohmann::ordered_json overlaps_json(const Bit& bit, const std::vector<CutterOverlap>& overlaps);

/// One warning with the number of pairs, their volume and the largest overlap. Empty without
/// overlaps.
std::string overlaps_text(const Bit& bit, const std::vector<CutterOverlap>& overlaps);

/// A warning for each part that lies inside another one if both have a density.
std::string enclosed_text(const Bit& bit);

}  // namespace tdbd::bit
