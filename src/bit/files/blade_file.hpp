#pragma once

#include <optional>
#include <vector>

#include "bit/body/blade_shape.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// The table [blades] of a bit file, beside a table of cutters or a design; nothing without it.
/// Keys: `exposure` and `slot_depth` (required), `width` (0: as wide as its cutters need), `wall`,
/// `gage_length`, `neck`, `shank_radius`, `shank_length` (of the gage radius), `edge`, `density`,
/// `rubs` (true), `cuts` (false). Mistakes are noted in `file`.
std::optional<BladeOptions> read_blades(Config& file);

/// Notes what makes the blades impossible for these cutters (bit/body/blade_body.hpp), at their
/// keys.
void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades);

}  // namespace tdbd::bit
