#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/cutter/cutter.hpp"

namespace tdbd::bit {

/// "cutter_overlaps" of analysis.json: the pairs and the volumes that count twice in the mass. SI.
nlohmann::ordered_json overlaps_json(const Bit& bit, const std::vector<CutterOverlap>& overlaps);

/// One warning with the number of pairs, their volume and the largest overlap. Empty without
/// overlaps.
std::string overlaps_text(const Bit& bit, const std::vector<CutterOverlap>& overlaps);

/// A warning for each part that lies inside another one if both have a density.
std::string enclosed_text(const Bit& bit);

/// Operating conditions of the analysis.
struct ReportOptions {
  double advance = 5e-3;            ///< m, penetration per revolution
  double bit_speed = 12.566;        ///< rad/s
  std::vector<double> cone_speeds;  ///< over the bit's; empty: speeds at which the gage rows roll
};

/// Returns the text of analysis.json, the analysis of a bit before drilling.
/// - Each cutter: place, rakes, under-exposure, wear, overlap with the next one, its outline
///   rotated into one half-plane, cut area and volume (bit_analysis.hpp), exposure, frame and tip.
/// - The bit: number of cutters that cut at each radius and their mean, imbalance of the unit law,
///   mass, centre, inertia, the body's profile, every part with its update direction, pairs of
///   cutters that overlap, the cutters' volume inside the body.
/// - With blades: "body" (body_report.hpp).
/// - With cones: the cones as in bit.json, what their rows sweep, the gaps between them, tracking
///   and contact ratios of their rows (cone_report.hpp), and the errors of the assumptions
///   about cones (cone_report.hpp).
/// What a bit does not have is an empty list, null, or absent. SI, units in the keys.
std::string analysis_json(const Bit& bit, const ReportOptions& options);

/// Writes analysis.json. Throws RunError if it cannot be written.
void write_analysis(const std::filesystem::path& folder, const Bit& bit,
                    const ReportOptions& options);

}  // namespace tdbd::bit
