#pragma once

#include <optional>
#include <vector>

#include "bit/body/blade_shape.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Reads the table [blades] of a bit file, beside a table of cutters or a design. Returns nothing
/// if it is absent. Keys: `exposure` and `slot_depth` (required), `width` (0: as wide as its
/// cutters require), `wall`, `gage_length`, `neck`, `shank_radius`, `shank_length` (over the gage
/// radius), `edge`, `density`, `rubs` (true), `cuts` (false). Mistakes are recorded in `file`.
std::optional<BladeOptions> read_blades(Config& file);

/// Records, at their keys, the reasons why the blades are impossible for these cutters
/// (bit/body/blade_body.hpp).
void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades);

}  // namespace tdbd::bit
