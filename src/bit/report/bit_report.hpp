#pragma once

#include <filesystem>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// How the bit is driven that is looked at.
struct ReportOptions {
  double advance = 5e-3;            ///< m, penetration per revolution
  double bit_speed = 12.566;        ///< rad/s
  std::vector<double> cone_speeds;  ///< over the bit's; none: at which the gage rows roll
};

/// analysis.json: what a designer asks of a bit before any drilling. Per cutter: place, rakes,
/// under-exposure, wear, overlap with the next one, its outline turned into one plane, cut area and
/// volume (bit/profile/engagement.hpp), exposure, frame and tip; of the bit: number of cutters that
/// cut at each radius and its mean, imbalance of the unit law, mass, centre, inertia, the body's
/// profile, every part with its update direction, pairs of cutters that overlap
/// (overlap_report.hpp), the cutters' volume inside the body; with blades, "body"
/// (body_report.hpp); of a cone bit its cones as in bit.json, what their rows sweep, the gaps
/// between them, tracking and contact ratios of its rows (tracking_report.hpp), what the
/// assumptions about cones are worth (assumption_report.hpp). README.md lists the keys. What a bit
/// has not is an empty list, a null, or absent. SI, units in the keys. Throws RunError when it
/// cannot be written.
void write_analysis(const std::filesystem::path& folder, const Bit& bit,
                    const ReportOptions& options);

}  // namespace tdbd::bit
