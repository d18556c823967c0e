#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Of the teeth of a cone that come from mesh files, one of each row: indices into bit.parts. Teeth are
/// in one row if they reach the same distances along and from the journal, to within `apart` (m).
std::vector<int> one_tooth_of_each_row(const Bit& bit, int cone, double apart);

/// The cutting parts of a bit, with every row of a cone replaced by what its teeth sweep in a full
/// turn of the cone: row_meridian turned about the journal, a surface in K without end caps, named
/// after its row ("cone-1/row-2"). For cones from mesh files, one tooth of each row is turned
/// (swept_meridian). A cone's body that cuts is kept as it is: turning about its own
/// axis, it sweeps itself. The corners of a row stand on inscribed circles of `segments` points.
/// Some tooth at some time reaches every point of such a part, and no tooth reaches beyond it by
/// more than radius (pi/segments)^2/2. A bit without cones keeps its own cutting parts.
std::vector<Part> swept_parts(const Bit& bit, int segments = 720);

}  // namespace tdbd::bit
