#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The part bit-body as a solid of revolution about the bit's axis, in the bit frame, that never
/// cuts. Its meridian joins the tips, each moved into the bit along the profile's normal by
/// `setback` times its cutter's diameter; above them come the gage and the shank. It represents
/// blades and waterways alike, so its mass (`density` in kg/m3) is an upper estimate. `gage_radius`
/// in m. Thesis: 3.1; the form is ours.
Part bit_body(const std::vector<Cutter>& cutters, double setback, double density,
              double gage_radius);

}  // namespace tdbd::bit
