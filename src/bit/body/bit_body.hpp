#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Makes the part bit-body: a solid of revolution about the bit's axis, in the bit frame, that
/// never cuts. Its meridian connects the tips, each moved into the bit along the profile's normal
/// by `setback` times its cutter's diameter; above them are the gage and the shank. It fills blades
/// and waterways, so its mass (`density` in kg/m3) is an upper estimate. `gage_radius` in m.
/// Thesis: 3.1; the shape is not in the thesis.
Part bit_body(const std::vector<Cutter>& cutters, double setback, double density,
              double gage_radius);

}  // namespace tdbd::bit
