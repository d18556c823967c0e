#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The cutting parts of a bit, with every row of a cone replaced by what its teeth sweep in a full
/// turn of the cone: row_meridian turned about the journal, a surface in K without end caps, named
/// after its row ("cone-1/row-2"). The rows of cones from mesh files are the sets of teeth in the same
/// place on their cone (swept_meridian). A cone's body that cuts is kept as it is: turning about its own
/// axis, it sweeps itself. The corners of a row stand on inscribed circles of `segments` points.
/// Some tooth at some time reaches every point of such a part, and no tooth reaches beyond it by
/// more than radius (pi/segments)^2/2. A bit without cones keeps its own cutting parts.
std::vector<Part> swept_parts(const Bit& bit, int segments = 720);

}  // namespace tdbd::bit
