#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/cutter_overlap.hpp"

namespace tdbd::simulation {

/// "cutter_overlaps" of analysis.json: pairs, their volumes and masses that count twice, SI.
nlohmann::ordered_json overlaps_json(const bit::Bit& bit,
                                     const std::vector<bit::CutterOverlap>& overlaps);

/// One warning with the number of pairs, their volume and the worst of them; empty without any.
std::string overlaps_text(const bit::Bit& bit, const std::vector<bit::CutterOverlap>& overlaps);

/// A warning for each part that lies inside another one, both with a density.
std::string enclosed_text(const bit::Bit& bit);

}  // namespace tdbd::simulation
