#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Builds a roller cone bit from the [[cones]] of a bit file. Thesis: 1.2, 3.1, fig. 3.5. Lengths
/// and angles are quantities. Those of [journal] and [teeth] are defaults for every cone and every
/// row.
///   gage_diameter           cones with a gage row are placed so that it reaches this; optional
///   interference            "refuse" (default) or "report" overlaps of cones with cones and legs
///   [journal]  angle, offset, skew, apex, foot_height      as in ConeLayout
///   [teeth]    kind, diameter, width, protrusion, crest_length, crest_width, tip_radius,
///              half_angle, embedding, density              as in ToothShape
///   [mesh]     segments, facets
///   [shank]    radius, length, height, density             no shank without a radius
///   [legs]     width, under_gage, clearance, tip_radius, shoulder, top, density, rubs, inserts,
///              insert_diameter, insert_length, insert_protrusion    as in Legs; requires a shank
///   [[cones]]  azimuth, journal_angle, offset, skew, apex, foot_height, density, body_cuts
///              (default false; true: the body crushes the rock left between prints), and
///              shell = [[s, r], ...] from the nose to the base, s outwards along the journal
///   [[cones.rows]]  s, sink, lean, gage; angles = [...], or teeth, first_angle and
///              spacing = [...] (ratios, repeated); and any key of [teeth]
/// Records every mistake at its line, finishes reading and builds the bit. Throws InputError.
Bit read_cone_bit(Config& file, const std::string& name);

/// Returns every kind of tooth with its name in a bit file.
std::vector<std::pair<std::string, ToothKind>> tooth_kinds();

/// Returns a roller cone bit as the text of a bit file, in SI, including its cones' positions along
/// their journals and their height. read_bit builds the same bit from it, up to rounding, and its
/// cones turn. Overlaps of neighbouring cones are reported, not refused, because the bit was built
/// with them.
std::string cone_bit_text(const Bit& bit);

}  // namespace tdbd::bit
