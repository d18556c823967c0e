#pragma once

#include <filesystem>

#include "bit/bit.hpp"

namespace tdbd::simulation {

/// analysis.json: what a designer asks of a bit before any drilling, at a penetration of `advance`
/// (m) a revolution. Per cutter: place, rakes, under-exposure, wear, overlap with the next one, its
/// outline turned into one plane, cut area and volume (bit/engagement.hpp); of the bit: number of
/// cutters that cut at each radius and its mean, imbalance of the unit law, mass, centre, inertia.
/// Pairs of cutters that overlap (overlap_report.hpp), the cutters' volume inside the body; with
/// blades, "body" (body_report.hpp); with cones, what the assumptions about them are worth at
/// bit_speed (rad/s; assumption_report.hpp). SI, units in the keys. Throws RunError when it cannot
/// be written.
void write_analysis(const std::filesystem::path& folder, const bit::Bit& bit, double advance,
                    double bit_speed);

}  // namespace tdbd::simulation
