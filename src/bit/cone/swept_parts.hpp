#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The cutting parts of a bit with every row of a cone replaced by what its teeth sweep in a full
/// turn of the cone: the meridian of row_meridian turned about the journal, a surface in K without
/// inner ends, named as its row ("cone-1/row-2"). A cone's body that cuts stays as it is: turning
/// about its own axis it sweeps itself. The corners of a row stand on circles of `segments`
/// points, inscribed. What such a part reaches some tooth reaches at some time, and no tooth
/// reaches beyond it by more than radius (pi/segments)^2/2. For a bit without cones its own parts.
std::vector<Part> swept_parts(const Bit& bit, int segments = 720);

}  // namespace tdbd::bit
