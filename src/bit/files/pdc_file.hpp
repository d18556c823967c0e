#pragma once

#include <optional>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/pdc_settings.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Makes the cutters that the [design] table of a bit file describes (pdc_generator.hpp). `c`: that
/// table. The gage radius (m) and the cutters' shape are given elsewhere in the file. Mistakes,
/// including those of an impossible design, are recorded in c at their keys; then the result is
/// empty.
std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape);

/// Reads the table [blades] of a bit file, beside a table of cutters or a design. Returns nothing
/// if it is absent. Mistakes are recorded in `file`.
std::optional<BladeOptions> read_blades(Config& file);

/// Records, at their keys, the reasons why the blades are impossible for these cutters
/// (bit/body/blade_body.hpp).
void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades);

/// Reads [adjust] and changes the cutters; changes are added up. Records as mistakes blades and
/// cutters that the bit does not have, and rakes or positions that no cutter can have.
void adjust_cutters(Config adjust, std::vector<Cutter>& cutters);

}  // namespace tdbd::bit
