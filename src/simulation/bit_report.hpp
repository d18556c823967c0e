#pragma once

#include <filesystem>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::simulation {

/// analysis.json: what a designer asks of a bit before any drilling, at a penetration of `advance`
/// (m) a revolution. Per cutter: place, rakes, under-exposure, wear, overlap with the next one, its
/// outline turned into one plane, cut area and volume (bit/engagement.hpp), exposure, frame and
/// tip; of the bit: number of cutters that cut at each radius and its mean, imbalance of the unit
/// law, mass, centre, inertia, the body's profile, every part with its update direction; of a cone
/// bit its cones as in bit.json, what their rows sweep, the gaps between them, tracking and contact
/// ratios of its rows (add_tracking) at these speeds of the cones over the bit's; without any, at
/// which their gage rows roll. README.md lists the keys. What a bit has not is an empty list, a
/// null, or absent. SI, units in the keys. Throws RunError when it cannot be written.
void write_analysis(const std::filesystem::path& folder, const bit::Bit& bit, double advance,
                    const std::vector<double>& cone_speeds);

}  // namespace tdbd::simulation
