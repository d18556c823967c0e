#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "bit/cutter_table.hpp"
#include "core/config.hpp"

namespace tdbd::simulation {

/// The cutters that the [design] table of a bit file lays out (pdc_generator.hpp). `c` is that
/// table; the gage radius (m) and the cutters' shape stand elsewhere in the file. Mistakes, those
/// of an impossible design included, are noted in c with their keys; then there are no cutters.
std::vector<bit::Cutter> read_design(Config c, double gage_radius,
                                     const bit::CutterDefaults& shape);

}  // namespace tdbd::simulation
