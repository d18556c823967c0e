#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Applies density, cutting, share and start from [areas.NAME] of a bit's file to its parts
/// (area_keys.hpp, bit_area_keys.hpp). The most specific area that defines a property decides.
/// Parts with density 0, whose volume is counted in another part, keep it, unless they are in
/// `without_density`; parts to which an area gives a density are removed from that list. If fewer
/// parts cut from the start, the gage radius becomes the largest radius that such a part reaches.
///
/// Records as mistakes: those of read_areas; two areas of equal rank that disagree; two starts in
/// one area; a density only for parts of density 0; a face or chamfer that rubs, because their
/// forces come from the rock that a face cuts; a share of parts that remove no rock, or of bodies
/// and shells of cones, which rock never leaves; a start of parts that never cut or rub; a start by
/// the wear of no cutter; and a bit of which no part ever cuts.
void apply_areas(Config& file, Bit& bit, std::vector<std::string>& without_density);

/// Returns the areas that define the properties of single parts which the other tables of an
/// exported bit do not contain: shares and starts, and for a bit with cones also densities and
/// cutting that differ from those of the cones' layouts. TOML; empty if there are none.
std::string areas_text(const Bit& bit);

}  // namespace tdbd::bit
