#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// Makes the cutters that the [design] table of a bit file describes (pdc_generator.hpp). `c`: that
/// table. The gage radius (m) and the cutters' shape are given elsewhere in the file. Mistakes,
/// including those of an impossible design, are recorded in c at their keys; then the result is
/// empty.
std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape);

}  // namespace tdbd::bit
