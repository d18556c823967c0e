#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Gives the parts of a bit the density, cutting, share and start of [areas.NAME] of its file
/// (area_keys.hpp, bit_area_keys.hpp), each from the most particular area that gives it. Parts with
/// density 0, whose volume counts elsewhere, keep it, unless they are in `without_density`; parts
/// that an area gives a density leave that list.
/// Where they leave less that cuts from the start, the gage radius becomes the largest that such a part
/// reaches. Notes as mistakes: those of read_areas; two areas of equal rank that disagree; two starts in one
/// area; a density for parts of density 0 alone; a face or chamfer that rubs, since their forces
/// come from what a face cuts; a share of parts that remove no rock, or of bodies and shells of cones, which rock never
/// leaves; a start of parts that never cut or rub; a start by the wear of no cutter; and a bit of which no part
/// cuts in the end.
void apply_areas(Config& file, Bit& bit, std::vector<std::string>& without_density);

/// The areas that say of single parts what the other tables of an exported bit do not: shares and starts; of a
/// bit with cones also densities and cutting that are not those of its cones' layouts. TOML; empty:
/// there is nothing to say.
std::string areas_text(const Bit& bit);

}  // namespace tdbd::bit
