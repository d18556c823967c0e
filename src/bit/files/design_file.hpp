#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// The cutters that the [design] table of a bit file lays out (pdc_generator.hpp). `c` is that
/// table; the gage radius (m) and the cutters' shape come from elsewhere in the file. Mistakes,
/// including those of an impossible design, are noted in c at their keys; then there are no
/// cutters.
std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape);

}  // namespace tdbd::bit
